#include "harness/review/decide.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/class_run/corrections.h"
#include "harness/grade/reread.h"
#include "harness/machine/errors.h"
#include "harness/record/concerns.h"
#include "harness/record/override_place.h"
#include "harness/report/class/wrong_answers.h"

namespace harness::review {
namespace {

using Kind = Decision::Kind;

constexpr const char* undo_reason = "undone in the review";

Override override_for(const Graded& graded, const Wish& wish, const Author& author) {
    const OverridePlace place = read_place(wish.about, graded);
    Override given{place.question, place.item, 0, read_line(wish.text, "the reason"), author.name, author.when};
    given.points = read_override_points(wish.points, points_at(graded.score, given).value());
    return given;
}

/// Throws UsageError if the place has no value of the item's shape.
Reread reread_for(const Session& session, std::size_t index, const Wish& wish, const Author& author) {
    const Graded& result = session.graded()[index];
    const OverridePlace place = read_item_place(wish.about, result);
    const std::string& printout = result.execution.printout;
    if (printout.empty()) throw UsageError(fmt::format("{} has no output to read again", result.submission.id));
    Reread given{place.question, place.item, wish.lines, layout_of(printout), read_line(wish.text, "the reason"),
                 author.name,    author.when};
    require_value(given, item_score(result, given).spec, result.score, printout);
    return given;
}

Decision decision_for(const Wish& wish, std::int64_t number, const Author& author) {
    Decision decision;
    decision.number = number;
    decision.kind = wish.kind;
    decision.about = wish.about;
    decision.text = wish.text;
    decision.by = author.name;
    decision.when = author.when;
    return decision;
}

/// Accepts the open concerns of a kind, or all if `kind` is empty. Returns their number.
std::size_t accept(Gradebook& gradebook, const Graded& graded, const std::string& kind, Decision decision) {
    std::size_t accepted = 0;
    decision.kind = Kind::accepted;
    for (const Flag& concern : open_concerns(graded)) {
        if (!kind.empty() && concern.kind != kind) continue;
        decision.about = concern.kind;
        decision.seen = seen_in(graded, concern);
        gradebook.put_decision({graded.submission.id, decision});
        ++accepted;
    }
    return accepted;
}

/// The override or reread of an item; empty if there is none.
template <class Given>
std::optional<Given> find_given(const std::vector<Given>& all, const std::string& item,
                                std::string (*item_of_given)(const Given&)) {
    const auto found = std::ranges::find(all, item, item_of_given);
    return found == all.end() ? std::nullopt : std::optional(*found);
}
std::optional<Override> find_override_at(const Graded& graded, const std::string& item) {
    return find_given(graded.review.overrides, item, place_of);
}
std::optional<Reread> find_reread(const Graded& graded, const std::string& item) {
    return find_given(graded.submission.rereads, item, item_of);
}

void decide_one(Session& session, Gradebook& gradebook, KeptClass& kept, std::size_t index, const Wish& wish,
                Decision decision) {
    const std::string id = kept.graded[index].submission.id;
    const Author author{decision.by, decision.when};
    switch (wish.kind) {
        case Kind::accepted:
            if (decision.text.empty()) decision.text = "reviewed; the marks stay";
            if (accept(gradebook, kept.graded[index], wish.about, decision) == 0)
                throw UsageError(fmt::format("{} no longer has this flag", id));
            return;
        case Kind::comment:
            decision.text = read_line(wish.text, "the comment");
            if (!wish.about.empty()) read_place(wish.about, kept.graded[index]);
            gradebook.put_decision({id, decision});
            return;
        case Kind::points: {
            const Override given = override_for(kept.graded[index], wish, author);
            decision.text = given.why;
            decision.replaced_override = find_override_at(kept.graded[index], wish.about);
            put_override(gradebook, kept, index, given);
            break;
        }
        case Kind::reading: {
            const Reread given = reread_for(session, index, wish, author);
            decision.text = given.why;
            decision.replaced_reread = find_reread(kept.graded[index], wish.about);
            put_reread(gradebook, kept, session.marking(), index, given);
            break;
        }
    }
    gradebook.put_decision({id, decision});
    if (wish.accepts_concerns) accept(gradebook, kept.graded[index], "", decision);
}

/// Whether the decision's value is still in force.
bool is_set_by(const auto& now, const Decision& decision) {
    return now && now->by == decision.by && now->when == decision.when && now->why == decision.text;
}

/// Undoes a decision for one submission. False if somebody has changed it since.
bool undo_one(Session& session, Gradebook& gradebook, KeptClass& kept, const KeptDecision& made, const Author& author) {
    const Decision& decision = made.given;
    const auto index = index_of(kept, made.submission);
    gradebook.undo_decision(made, author);
    if (decision.kind == Kind::accepted || decision.kind == Kind::comment) return true;
    if (!index) return false;
    const Graded& graded = kept.graded[*index];
    if (decision.kind == Kind::points) {
        const auto now = find_override_at(graded, decision.about);
        if (!is_set_by(now, decision)) return false;
        if (decision.replaced_override) {
            put_override(gradebook, kept, *index, *decision.replaced_override);
        } else {
            remove_override(gradebook, kept, {made.submission, *now}, author, undo_reason);
        }
        return true;
    }
    const auto now = find_reread(graded, decision.about);
    if (!is_set_by(now, decision)) return false;
    if (decision.replaced_reread) {
        put_reread(gradebook, kept, session.marking(), *index, *decision.replaced_reread);
    } else {
        remove_reread(gradebook, kept, session.marking(), {made.submission, *now}, author, undo_reason);
    }
    return true;
}

/// The submissions that made the same mistake in the item or question.
std::vector<std::size_t> same_mistake(const Session& session, std::size_t index, const std::string& about) {
    for (const report::QuestionMistakes& question : report::mistakes_by_question(session.graded())) {
        for (const report::WrongAnswer& answer : question.answers) {
            const std::string all = std::to_string(question.question);
            const bool is_about = answer.whole_question ? about == all || about.starts_with(all + ".")
                                                        : about == fmt::format("{}.{}", all, answer.spec.name);
            if (!is_about || answer.differing) continue;
            if (std::find(answer.who.begin(), answer.who.end(), index) != answer.who.end()) return answer.who;
        }
    }
    return {};
}

std::vector<std::size_t> same_concern(const Session& session, std::size_t index, const std::string& kind) {
    std::vector<std::size_t> candidates = session.with_layout_of(index);
    if (kind != "reading_doubtful") {
        candidates.clear();
        for (std::size_t i = 0; i < session.graded().size(); ++i) candidates.push_back(i);
    }
    std::erase_if(candidates, [&](std::size_t i) {
        const std::vector<Flag> open = open_concerns(session.graded()[i]);
        return std::none_of(open.begin(), open.end(), [&](const Flag& flag) { return flag.kind == kind; });
    });
    return candidates;
}

}  // namespace

Group alike(const Session& session, std::size_t index, const Wish& wish) {
    switch (wish.kind) {
        case Kind::accepted:
            return {wish.about == "reading_doubtful" ? "a doubtful reading of an output with the same layout"
                                                     : "the same flag",
                    same_concern(session, index, wish.about)};
        case Kind::reading: return {"an output with the same layout", session.with_layout_of(index)};
        case Kind::points:
            return {"the same mistake in " + place_in_words(wish.about), same_mistake(session, index, wish.about)};
        case Kind::comment: break;
    }
    if (!wish.about.empty())
        return {"the same mistake in " + place_in_words(wish.about), same_mistake(session, index, wish.about)};
    return {"an output with the same layout", session.with_layout_of(index)};
}

Graded after(const Session& session, std::size_t index, const Wish& wish) {
    Graded result = session.graded()[index];
    const Author author = session.author();
    if (wish.kind == Kind::points) {
        set_override(result, override_for(result, wish, author));
    } else if (wish.kind == Kind::reading) {
        set_reread(result, session.marking(), reread_for(session, index, wish, author));
    } else if (wish.kind == Kind::comment) {
        read_line(wish.text, "the comment");
        if (!wish.about.empty()) read_place(wish.about, result);
    }
    return result;
}

std::int64_t decide(Session& session, const std::vector<Shown>& shown, const Wish& wish) {
    std::int64_t number = 0;
    const Author author = session.author();
    session.change([&](Gradebook& gradebook, KeptClass& kept) {
        const std::vector<std::size_t> indices = session.indices_of(shown);
        number = gradebook.next_decision();
        for (const std::size_t index : indices)
            decide_one(session, gradebook, kept, index, wish, decision_for(wish, number, author));
        return indices;
    });
    return number;
}

Undone undo(Session& session, std::int64_t number, const std::string& only) {
    Undone undone;
    const Author author = session.author();
    session.change([&](Gradebook& gradebook, KeptClass& kept) {
        std::vector<std::size_t> changed;
        const std::vector<KeptDecision> made = kept.decisions;
        // In reverse order, because a decision may have accepted a concern after an earlier one gave points.
        for (auto each = made.rbegin(); each != made.rend(); ++each) {
            if (each->given.number != number || (!only.empty() && each->submission != only)) continue;
            const bool done = undo_one(session, gradebook, kept, *each, author);
            auto& list = done ? undone.submissions : undone.left;
            if (std::find(list.begin(), list.end(), each->submission) == list.end()) list.push_back(each->submission);
            if (const auto index = index_of(kept, each->submission)) changed.push_back(*index);
        }
        return changed;
    });
    return undone;
}

void take_back(Session& session, const Shown& shown, Decision::Kind kind, const std::string& item) {
    constexpr const char* reason = "taken back in the review";
    const Author author = session.author();
    session.change([&](Gradebook& gradebook, KeptClass& kept) {
        const std::size_t index = session.indices_of({shown}).front();
        const Graded& graded = kept.graded[index];
        const std::string& id = graded.submission.id;
        if (kind == Kind::points) {
            const auto now = find_override_at(graded, item);
            if (!now) throw UsageError(fmt::format("{} of {} no longer has an override", item, id));
            remove_override(gradebook, kept, {id, *now}, author, reason);
        } else {
            const auto now = find_reread(graded, item);
            if (!now) throw UsageError(fmt::format("{} of {} no longer has a correction", item, id));
            remove_reread(gradebook, kept, session.marking(), {id, *now}, author, reason);
        }
        return std::vector{index};
    });
}

}  // namespace harness::review
