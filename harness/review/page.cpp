#include "harness/review/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/record/concern_titles.h"
#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"
#include "harness/report/text/sentences.h"
#include "harness/report/text/verdict_words.h"
#include "harness/review/past.h"
#include "harness/review/templates.h"
#include "harness/text/markup.h"
#include "harness/text/points.h"

namespace harness::review {
namespace {

using Kind = Decision::Kind;
using report::list_of;
using report::PageData;
using report::PageTemplate;

std::string wish_in_words(const Wish& wish) {
    const std::string place = place_in_words(wish.about);
    switch (wish.kind) {
        case Kind::accepted: return fmt::format("Accept: {}.", title_of(wish.about).of_many);
        case Kind::points: return fmt::format("Give {} points for {}: {}", wish.points, place, wish.text);
        case Kind::reading:
            return wish.lines.empty() ? fmt::format("Not printed: {} ({})", place, wish.text)
                                      : fmt::format("Read {} from line {}: {}", place, wish.lines, wish.text);
        case Kind::comment: return fmt::format("Comment{}: {}", wish.about.empty() ? "" : " on " + place, wish.text);
    }
    return "";
}

/// The evidence or the printed answer that the decision is about.
std::string what_is_there(const Graded& graded, const Wish& wish) {
    for (const Flag& concern : open_concerns(graded)) {
        if (wish.kind == Kind::accepted && concern.kind == wish.about)
            return report::evidence_text(graded, concern, Audience::instructor);
    }
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (item_name(item) == wish.about)
                return fmt::format("{}{}{}", report::word_of(item.verdict), item.printed.empty() ? "" : ": ",
                                   item.printed);
        }
    }
    return "";
}

/// The sentences of a case's concern. If there are several, each comes with its students.
PageData reasons_of(const std::vector<Graded>& graded, const Case& one) {
    std::vector<std::string> sentences;
    std::map<std::string, std::string> students;  // by sentence
    for (const std::size_t index : one.indices) {
        for (const Flag& concern : open_concerns(graded[index])) {
            if (concern.kind != one.concern.kind) continue;
            const std::string sentence = report::evidence_text(graded[index], concern, Audience::instructor);
            const auto [found, is_new] = students.try_emplace(sentence);
            if (is_new) sentences.push_back(sentence);
            found->second += (found->second.empty() ? "" : ", ") + name_of(graded[index].submission);
        }
    }
    return list_of(sentences, [&](PageData& reason, const std::string& sentence) {
        reason["evidence"] = sentence;
        if (sentences.size() > 1) reason["evidence_of"] = students.at(sentence);
    });
}

}  // namespace

std::string page_policy() {
    return "default-src 'none'; style-src 'self'; script-src 'self'; img-src 'self'; form-action 'self'; base-uri "
           "'none'; frame-ancestors 'none'";
}

std::string name_of(const Submission& submission) {
    const std::string label = label_of(submission);
    return label == submission.id ? label : fmt::format("{} ({})", label, submission.id);
}

Pages::Pages(const Session& session, std::string root) : session_(session), root_(std::move(root)) {}

std::string item_name(const ItemScore& item) {
    return fmt::format("{}.{}", item.spec.question, item.spec.name);
}

std::string mark_of(const Graded& graded) {
    const auto points = points_that_count(graded);
    return points ? points_text(*points) : "no mark";
}

std::string Pages::path_of(std::size_t index) const {
    return fmt::format("{}/student/{}", root_, index + 1);
}

std::string Pages::framed(const std::string& title, const std::string& body) const {
    PageData data;
    data["root"] = root_;
    data["page_title"] = title;
    data["page_body"] = body;
    return PageTemplate(templates::frame_mustache).fill_in(data);
}

std::string Pages::notice_html(const std::optional<Notice>& notice, const std::string& back) const {
    if (!notice) return "";
    PageData data;
    data["root"] = root_;
    data["sentence"] = notice->sentence;
    data["look"] = std::string(notice->is_problem ? "bad" : "good");
    data["role"] = std::string(notice->is_problem ? "alert" : "status");
    data["back"] = back;
    if (notice->decision) data["undo_number"] = std::to_string(*notice->decision);
    return PageTemplate(templates::notice_mustache).fill_in(data);
}

std::string Pages::message(const std::string& heading, const std::string& sentence) const {
    const std::string home = root_.empty() ? "" : fmt::format("<p><a href=\"{}/\">Back to the list</a></p>\n", root_);
    return framed(heading, fmt::format("<main>\n<h1>{}</h1>\n<p role=\"alert\">{}</p>\n{}</main>\n",
                                       escape_markup(heading), escape_markup(sentence), home));
}

PageData Pages::past() const {
    std::map<std::string, std::size_t> indices;
    for (std::size_t i = 0; i < session_.graded().size(); ++i) indices[session_.graded()[i].submission.id] = i;
    const auto linked_names = [&](const std::vector<std::string>& ids) {
        return list_of(ids, [&](PageData& student, const std::string& id) {
            const auto found = indices.find(id);
            student["past_name"] = found == indices.end() ? id : name_of(session_.graded()[found->second].submission);
            if (found != indices.end()) student["past_path"] = path_of(found->second);
            student["past_last"] = &id == &ids.back();
        });
    };
    return list_of(past_decisions(session_.kept()), [&](PageData& past, const PastDecision& past_decision) {
        past["past_number"] = std::to_string(past_decision.number);
        past["past_what"] = past_decision.what;
        past["past_by"] = past_decision.by;
        past["past_when"] = past_decision.when;
        if (!past_decision.why.empty()) past["past_why"] = past_decision.why;
        past["past_who"] = linked_names(past_decision.submissions);
        past["past_undo"] = !past_decision.in_force.empty();
        past["past_undone"] = list_of(past_decision.taken_back, [&](PageData& page_data, const TakenBack& back) {
            page_data["undone_by"] = back.by;
            page_data["undone_when"] = back.when;
            // Names the students, unless it was undone for all of them.
            if (back.submissions.size() < past_decision.submissions.size()) {
                page_data["undone_for_some"] = true;
                page_data["undone_who"] = linked_names(back.submissions);
            }
        });
    });
}

PageData Pages::case_data(const Case& one, const std::string& kind) const {
    const std::vector<Graded>& graded = session_.graded();
    PageData data;
    data["who"] = list_of(one.indices, [&](PageData& student, std::size_t index) {
        student["who_path"] = path_of(index);
        student["who_name"] = name_of(graded[index].submission);
        student["who_points"] = mark_of(graded[index]);
        student["who_last"] = index == one.indices.back();
    });
    data["reasons"] = reasons_of(graded, one);
    data["accept_all"] = one.indices.size() > 1;
    data["accept_id"] = graded[one.indices.front()].submission.id;
    data["accept_state"] = session_.state_of(one.indices.front());
    data["accept_kind"] = kind;
    data["accept_count"] = std::to_string(one.indices.size());
    return data;
}

PageData Pages::chapters(const Agenda& agenda) const {
    return list_of(agenda.chapters, [&](PageData& chapter, const Chapter& each) {
        std::size_t count = 0;
        chapter["chapter"] = title_of(each.kind).of_many;
        chapter["cases"] = list_of(each.cases, [&](PageData& data, const Case& one) {
            count += one.indices.size();
            data = case_data(one, each.kind);
        });
        chapter["chapter_count"] = std::to_string(count);
    });
}

PageData Pages::students() const {
    PageData list(PageData::type::list);
    for (std::size_t i = 0; i < session_.graded().size(); ++i) {
        const Graded& result = session_.graded()[i];
        const bool is_open = !open_concerns(result).empty();
        PageData student;
        student["student_path"] = path_of(i);
        student["student_name"] = name_of(result.submission);
        student["student_points"] = mark_of(result);
        student["student_outcome"] = report::outcome_words(result.execution.outcome);
        student["student_review"] = std::string(is_open ? "to review" : concerns_of(result).empty() ? "" : "accepted");
        list.push_back(student);
    }
    return list;
}

std::string Pages::list(const std::optional<Notice>& notice) {
    const Agenda agenda = agenda_of(session_);
    PageData data;
    data["root"] = root_;
    data["title"] = session_.marking().assignment.title;
    data["open"] = std::to_string(agenda.open.size());
    data["concerned"] = std::to_string(agenda.concerned);
    data["notice"] = notice_html(notice, "");
    data["begin"] = !agenda.open.empty();
    if (!agenda.open.empty()) {
        data["begin_path"] = path_of(agenda.open.front());
        data["begin_name"] = name_of(session_.graded()[agenda.open.front()].submission);
    }
    data["chapters"] = chapters(agenda);
    PageData decisions = past();
    data["has_past"] = decisions.is_non_empty_list();
    data["past"] = std::move(decisions);
    data["students"] = students();
    return framed("Review: " + session_.marking().assignment.title,
                  PageTemplate(templates::list_mustache).fill_in(data));
}

std::string Pages::group(std::size_t index, const Wish& wish, const Group& group) {
    const std::vector<Graded>& graded = session_.graded();
    PageData data;
    data["root"] = root_;
    data["title"] = session_.marking().assignment.title;
    data["wish"] = wish_in_words(wish);
    data["cause"] = group.cause;
    data["wish_kind"] = std::string(to_string(wish.kind));
    data["wish_about"] = wish.about;
    data["wish_points"] = wish.points;
    data["wish_lines"] = wish.lines;
    data["wish_text"] = wish.text;
    data["wish_none"] = wish.kind == Kind::reading && wish.lines.empty();
    data["wish_accepts"] = wish.accepts_concerns;
    data["first_id"] = graded[index].submission.id;
    data["back"] = path_of(index);
    PageData members(PageData::type::list);
    std::vector<std::string> lowered;
    for (const std::size_t each : group.indices) {
        PageData member;
        const Graded& now = graded[each];
        member["member_value"] = session_.state_of(each) + now.submission.id;
        member["member_name"] = name_of(now.submission);
        member["member_now"] = mark_of(now);
        member["member_what"] = what_is_there(now, wish);
        try {
            const Graded then = after(session_, each, wish);
            member["member_then"] = mark_of(then);
            member["member_can"] = true;
            const std::string less = wish.kind == Kind::points ? lowered_by(now, then.review.overrides.back()) : "";
            member["member_lower"] = !less.empty();
            if (!less.empty()) lowered.push_back(less);
        } catch (const UsageError& error) {
            member["member_then"] = std::string();
            member["member_what"] = std::string(error.what());
            member["member_can"] = false;
        }
        members.push_back(member);
    }
    data["members"] = std::move(members);
    report::set_text(data, "lowered", lowered_sentence(lowered));
    data["apply"] = std::string("Apply to these students");
    return framed("Which students?", PageTemplate(templates::group_mustache).fill_in(data));
}

}  // namespace harness::review
