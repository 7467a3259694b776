// The page of one student: Pages::student and its helpers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "harness/class_run/corrections.h"
#include "harness/mark/score/doubts_text.h"
#include "harness/record/concern_titles.h"
#include "harness/record/concerns.h"
#include "harness/record/override_place.h"
#include "harness/report/compile_error/compiler_messages.h"
#include "harness/report/page/evidence.h"
#include "harness/report/page/listing.h"
#include "harness/report/text/expected_text.h"
#include "harness/report/text/sentences.h"
#include "harness/report/text/verdict_words.h"
#include "harness/review/page.h"
#include "harness/review/source_notes.h"
#include "harness/review/templates.h"
#include "harness/text/points.h"

namespace harness::review {
namespace {

using Kind = Decision::Kind;
using report::list_of;
using report::PageData;
using report::PageTemplate;
using report::set_text;

constexpr std::size_t most_bytes = 64 << 10U;

/// Whether the doubt is about the item, and not about its whole question or output.
bool is_of_item(const Doubt& doubt) {
    return doubt.why != Doubt::Why::words_left && doubt.why != Doubt::Why::numbers_left &&
           doubt.why != Doubt::Why::little_read;
}

/// The item that a decision is probably about: the first doubtful item, else the first item of a doubtful question,
/// else the first one that is not right. Null if all are right.
const ItemScore* item_to_look_at(const Graded& graded) {
    const ItemScore* itself = nullptr;
    const ItemScore* by_question = nullptr;
    const ItemScore* wrong = nullptr;
    const auto keep_first = [](const ItemScore*& first, const ItemScore& item, bool is_one) {
        if (first == nullptr && is_one) first = &item;
    };
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            keep_first(itself, item, item.doubt && is_of_item(*item.doubt));
            keep_first(by_question, item, item.doubt.has_value());
            keep_first(wrong, item, item.verdict != ItemVerdict::right && item.verdict != ItemVerdict::follow);
        }
    }
    return itself != nullptr ? itself : by_question != nullptr ? by_question : wrong;
}

/// A list of choices for <select>.
class Options {
  public:
    explicit Options(std::string chosen) : chosen_(std::move(chosen)) {}

    void add(const std::string& value, const std::string& text) {
        PageData option;
        option["option"] = value;
        option["option_text"] = text;
        option["option_chosen"] = value == chosen_;
        list_.push_back(option);
    }
    PageData take() { return std::move(list_); }

  private:
    std::string chosen_;
    PageData list_{PageData::type::list};
};

PageData item_options(const Graded& graded, const std::string& chosen) {
    Options options(chosen);
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items)
            options.add(item_name(item),
                        fmt::format("{}: {}", place_in_words(item_name(item)), report::word_of(item.verdict)));
    }
    return options.take();
}

/// Every place that can get points, with its maximum.
PageData point_options(const Graded& graded, const std::string& chosen) {
    Options options(chosen);
    const bool has_items = graded.execution.outcome != Outcome::not_graded;
    for (const QuestionScore& question : graded.score.questions) {
        if (!has_items) break;
        for (const ItemScore& item : question.items) {
            options.add(item_name(item),
                        fmt::format("{}: {} of {}", place_in_words(item_name(item)),
                                    points_text(final_points(graded, question, item)), points_text(item.max_points)));
        }
        options.add(std::to_string(question.number),
                    fmt::format("question {}: {} of {}", question.number, points_text(final_points(graded, question)),
                                points_text(question.max_points)));
    }
    if (graded.score.variants)
        options.add(std::string(variants_place),
                    fmt::format("other scenes: {} of {}", points_text(final_scenes_points(graded)),
                                points_text(graded.score.variants->max_points)));
    options.add("total",
                fmt::format("the whole submission: {} of {}", mark_of(graded), points_text(graded.score.max_points)));
    return options.take();
}

PageData comment_options(const Graded& graded, const std::string& chosen) {
    Options options(chosen);
    if (graded.execution.outcome == Outcome::not_graded) return options.take();
    for (const QuestionScore& question : graded.score.questions) {
        options.add(std::to_string(question.number), fmt::format("question {}", question.number));
        for (const ItemScore& item : question.items) options.add(item_name(item), place_in_words(item_name(item)));
    }
    return options.take();
}

std::string facts_of(const Graded& graded) {
    std::string facts = graded.submission.file.string();
    if (graded.late_share > 0) {
        facts += fmt::format("{}late: {:g} % off", facts.empty() ? "" : ", ", graded.late_share * 100);
    }
    return facts;
}

PageData items_of(const Graded& graded, const QuestionScore& question, const report::ExpectedTexts& asked,
                  const Computing& computing, const report::Listing& source) {
    return list_of(question.items, [&](PageData& item, const ItemScore& scored) {
        item["item"] = item_name(scored);
        item["item_shown"] = std::string(name_in_words(scored.spec.name));
        item["item_class"] = std::string(to_string(scored.verdict));
        item["item_word"] = std::string(report::word_of(scored.verdict));
        item["item_got"] = points_text(final_points(graded, question, scored));
        item["item_most"] = points_text(scored.max_points);
        set_text(item, "item_printed", scored.printed);
        if (scored.line != 0) item["item_line"] = std::to_string(scored.line);
        const int look = scored.doubt && scored.doubt->line > 0 ? scored.doubt->line : scored.line;
        if (look != 0) item["item_look"] = std::to_string(look);
        const auto printing = computing.first_printing.find(item_name(scored));
        if (printing != computing.first_printing.end() && source.has_anchor(printing->second)) {
            item["item_source"] = fmt::format("{}", fmt::join(computing.lines.at(item_name(scored)), " "));
            item["item_printing"] = std::to_string(printing->second);
        }
        const auto right = asked.find(scored.spec.id);
        if (scored.verdict != ItemVerdict::right && right != asked.end())
            item["item_asked"] = right->second.beside(scored);
        // For the other verdicts the word is enough, and the student's page explains how to print a missing answer.
        const bool needs_words = scored.verdict == ItemVerdict::wrong || scored.verdict == ItemVerdict::unreadable ||
                                 !scored.advice.empty() || !scored.accepted_as.empty() || !scored.reread.empty();
        if (needs_words) set_text(item, "item_sentence", report::item_sentence(scored, graded.execution.outcome));
        set_text(item, "item_found", report::how_found(scored));
    });
}

PageData questions_of(const Graded& graded, const report::ExpectedTexts& asked, const Computing& computing,
                      const report::Listing& source) {
    PageData questions(PageData::type::list);
    if (graded.execution.outcome == Outcome::not_graded) return questions;
    for (const QuestionScore& each : graded.score.questions) {
        PageData question;
        question["question"] = std::to_string(each.number);
        question["question_title"] = each.title;
        question["question_got"] = points_text(final_points(graded, each));
        question["question_most"] = points_text(each.max_points);
        question["items"] = items_of(graded, each, asked, computing, source);
        questions.push_back(question);
    }
    return questions;
}

/// The answers read from each line, and the lines where a doubtful item may be.
report::LineNotes notes_of_printout(const Graded& graded) {
    report::LineNotes notes = report::notes_of_answers(graded.score);
    std::map<int, std::vector<std::string>> doubtful;
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.doubt && item.doubt->line > 0)
                doubtful[item.doubt->line].push_back(place_in_words(item_name(item)));
        }
    }
    constexpr std::size_t most = 3;
    for (const auto& [line, items] : doubtful) {
        if (items.size() <= most) {
            notes[line].push_back({fmt::format("is this {}?", fmt::join(items, " or ")), "warning"});
        } else {
            notes[line].push_back({fmt::format("is this one of {} answers?", items.size()), "warning"});
        }
    }
    return notes;
}

report::LineNotes notes_of_source(const Graded& graded, const Computing& computing) {
    report::LineNotes notes = report::notes_of_compiler(report::compiler_messages(graded.execution.build.diagnostics));
    for (const auto& [line, more] : computing.notes) notes[line].insert(notes[line].end(), more.begin(), more.end());
    return notes;
}

/// Overrides, rereads and decisions in force.
PageData decided_of(const Graded& graded) {
    PageData list(PageData::type::list);
    const auto add = [&](const std::string& text, const std::string& when, const std::string& why, const char* what,
                         const std::string& about) {
        PageData decided;
        decided["decided_text"] = text;
        set_text(decided, "decided_when", when);
        set_text(decided, "decided_why", why);
        decided["decided_what"] = std::string(what);
        decided["decided_about"] = about;
        list.push_back(decided);
    };
    for (const Override& given : graded.review.overrides) {
        const std::string place = place_of(given);
        add(fmt::format("{} points for {}, by {}", points_text(given.points), place_in_words(place), given.by),
            given.when, given.why, "override", place);
    }
    for (const Reread& reread : graded.submission.rereads) {
        const std::string place = item_of(reread);
        add(fmt::format(
                "{}: {}{}", report::capitalized(place_in_words(place)), harness::note_of(reread),
                counts(graded, reread) ? "" : " (does not count, because the layout of the output has changed)"),
            "", "", "reread", place);
    }
    for (const Decision& decision : graded.review.decisions) {
        if (decision.kind != Kind::accepted && decision.kind != Kind::comment) continue;
        add(fmt::format("{}, by {}", report::decision_in_words(decision), decision.by), decision.when, decision.text,
            "decision", std::to_string(decision.number));
    }
    return list;
}

}  // namespace

/// The open concerns, each with a form to accept it.
void Pages::add_concerns(PageData& data, std::size_t index, const std::optional<Wish>& tried) const {
    const Graded& result = session_.graded()[index];
    const std::vector<Flag> open = open_concerns(result);
    data["concerns"] = list_of(open, [&](PageData& concern, const Flag& flag) {
        concern["concern_title"] = title_of(flag.kind).of_many;
        concern["concern_kind"] = flag.kind;
        concern["evidence"] = report::evidence_text(result, flag, Audience::instructor);
        concern["concern_text"] = tried && tried->kind == Kind::accepted ? tried->text : std::string();
        concern["is_first"] = &flag == &open.front();
        const std::size_t size = alike(session_, index, {Kind::accepted, flag.kind, {}, {}, {}, false}).indices.size();
        if (size > 1) concern["concern_group"] = std::to_string(size);
    });
    data["has_concerns"] = !open.empty();
}

/// The forms for a reading, points and a comment, filled in with the refused values or with the most probable ones.
void Pages::add_decision_forms(PageData& data, std::size_t index, const std::optional<Wish>& tried) const {
    const Graded& result = session_.graded()[index];
    const ItemScore* item = item_to_look_at(result);
    // After a refusal, the instructor still works on the same item.
    const bool is_about_item = tried && tried->kind != Kind::accepted && tried->about.find('.') != std::string::npos;
    const std::string default_item = is_about_item ? tried->about : item == nullptr ? "" : item_name(*item);
    const auto chosen = [&](Kind kind, const std::string& otherwise) {
        return tried && tried->kind == kind ? tried->about : otherwise;
    };
    const auto typed = [&](Kind kind, const std::string Wish::*field) {
        return tried && tried->kind == kind ? *tried.*field : std::string();
    };
    const bool can_reread = !result.execution.printout.empty();
    data["can_reread"] = can_reread;
    data["reading_items"] = item_options(result, chosen(Kind::reading, default_item));
    const bool knows_line = item != nullptr && item->doubt && item->doubt->line > 0 && item_name(*item) == default_item;
    data["reading_lines"] = tried && tried->kind == Kind::reading ? tried->lines
                            : knows_line                          ? std::to_string(item->doubt->line)
                                                                  : std::string();
    data["reading_none"] = tried && tried->kind == Kind::reading && tried->lines.empty();
    data["reading_text"] = typed(Kind::reading, &Wish::text);
    const std::size_t with_layout = session_.with_layout_of(index).size();
    if (with_layout > 1) data["layout_group"] = std::to_string(with_layout);
    data["point_items"] = point_options(
        result, chosen(Kind::points, result.execution.outcome == Outcome::not_graded ? "total" : default_item));
    data["points_given"] = typed(Kind::points, &Wish::points);
    data["points_text"] = typed(Kind::points, &Wish::text);
    data["comment_items"] = comment_options(result, chosen(Kind::comment, ""));
    data["comment_text"] = typed(Kind::comment, &Wish::text);
}

std::string Pages::student(std::size_t index, const std::optional<Notice>& notice, const std::optional<Wish>& tried) {
    const Graded& result = session_.graded()[index];
    const Marking& own = own_marking(session_.marking(), result.submission);
    const Agenda agenda = agenda_of(session_);
    PageData data;
    data["root"] = root_;
    data["id"] = result.submission.id;
    data["state"] = session_.state_of(index);
    data["name"] = name_of(result.submission);
    data["facts"] = facts_of(result);
    if (points_that_count(result)) data["points"] = mark_of(result);
    data["max"] = points_text(result.score.max_points);
    const auto link = [&](const char* name, const std::optional<std::size_t>& there) {
        if (there) data[name] = path_of(*there);
    };
    link("previous", before(agenda, index));
    link("next", next(agenda, index));
    link("next_open", next_open(agenda, index));
    data["standing"] = fmt::format("{} of {} left to review", agenda.open.size(), agenda.concerned);
    data["notice"] = notice_html(notice, result.submission.id);
    set_text(data, "explanation", result.execution.explanation);

    add_concerns(data, index, tried);
    add_decision_forms(data, index, tried);
    PageData decided = decided_of(result);
    data["has_decided"] = decided.is_non_empty_list();
    data["decided"] = std::move(decided);

    const Computing computing = computing_lines(result.submission.source, result.execution.printout, result.score);
    const report::Listing printout =
        report::Listing::of_printout(report::shown_printout(result), notes_of_printout(result), "line-");
    const report::Listing source =
        report::Listing::of_source(result.submission.source, notes_of_source(result, computing), "source-");
    if (!printout.empty()) data["printout"] = printout.html("Output");
    if (report::is_printout_too_long(result)) data["no_printout"] = std::string(report::too_long_sentence);
    if (printout.empty()) data["no_printout"] = std::string("No output was kept.");
    if (!source.empty()) data["source"] = source.html("Source");
    data["no_source"] =
        std::string(result.submission.source_sha256.empty()
                        ? "No source was submitted."
                        : "The gradebook has no source: it was too long or an older raygrade graded it. "
                          "Grade again with --apply to keep it.");

    data["questions"] = questions_of(result, report::expected_texts(own.key), computing, source);
    if (result.execution.outcome != Outcome::not_graded && result.execution.outcome != Outcome::compile_error)
        data["picture"] = report::explaining_picture(own, &result, true, "scene-");
    const report::Evidence evidence{"h2", most_bytes, Audience::instructor};
    data["evidence"] = evidence.compiler(result, source) + evidence.others(result, printout, source);
    return framed(name_of(result.submission) + ", review", PageTemplate(templates::student_mustache).fill_in(data));
}

}  // namespace harness::review
