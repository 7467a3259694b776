// The gradebook's overrides and rereads.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "harness/gradebook/database.h"
#include "harness/gradebook/gradebook.h"
#include "harness/gradebook/record.h"
#include "harness/gradebook/rows.h"
#include "harness/text/points.h"

namespace harness {
namespace {

using SQLite::Statement;

std::string override_text(const Override& given) {
    return fmt::format("{}: {}", points_text(given.points), given.why);
}

std::string override_of(const KeptOverride& kept) {
    return fmt::format("override of {} of {}", place_of(kept.given), kept.submission);
}

std::string reread_text(const Reread& given) {
    return fmt::format("{}: {}", given.lines.empty() ? "not printed" : "line " + given.lines, given.why);
}

std::string reread_of(const KeptReread& kept) {
    return fmt::format("reading of {}.{} of {}", kept.given.question, kept.given.item, kept.submission);
}

/// The line that the item was read from: "line 12"; empty if it was not found.
std::optional<std::string> line_of(const Graded& graded, const Reread& given) {
    for (const QuestionScore& question : graded.score.questions) {
        for (const ItemScore& item : question.items) {
            if (question.number == given.question && item.spec.name == given.item && item.line > 0)
                return fmt::format("line {}", item.line);
        }
    }
    return std::nullopt;
}

std::optional<std::string> mark_text_of(const Graded& graded) {
    const auto points = points_that_count(graded);
    return points ? std::optional(points_text(*points)) : std::nullopt;
}

}  // namespace

std::vector<KeptOverride> Gradebook::overrides() const {
    if (!database_) return {};
    return in_database(file_, [&] {
        Statement query(*database_,
                        "SELECT submission, question, item, points, why, who, at FROM overrides ORDER BY at, rowid");
        std::vector<KeptOverride> all;
        while (query.executeStep()) {
            const auto text = [&](int column) { return query.getColumn(column).getString(); };
            all.push_back(
                {new_id(text(0)),
                 {query.getColumn(1).getInt(), text(2), query.getColumn(3).getDouble(), text(4), text(5), text(6)}});
        }
        return all;
    });
}

void Gradebook::put_override(const KeptOverride& kept, double automatic, const std::optional<double>& points) {
    write([&] {
        std::string before = fmt::format("{}, automatically", points_text(automatic));
        for (const KeptOverride& kept_override : overrides()) {
            if (is_same_place(kept_override, kept)) before = override_text(kept_override.given);
        }
        write_override(*database_, kept);
        write_final_points(*database_, kept.submission, points);
        write_audit(*database_, {kept.given.by, kept.given.when}, override_of(kept), before, override_text(kept.given));
    });
}

void Gradebook::remove_override(const KeptOverride& removed, const Author& author, const std::string& why,
                                const std::optional<double>& points) {
    write([&] {
        erase_correction(*database_, "overrides", removed.submission, removed.given.question, removed.given.item);
        write_final_points(*database_, removed.submission, points);
        write_audit(*database_, author, override_of(removed), override_text(removed.given), "removed: " + why);
    });
}

std::vector<KeptReread> Gradebook::rereads() const {
    if (!database_) return {};
    return in_database(file_, [&] {
        Statement query(
            *database_,
            "SELECT submission, question, item, lines, layout, why, who, at FROM rereads ORDER BY at, rowid");
        std::vector<KeptReread> all;
        while (query.executeStep()) {
            const auto text = [&](int column) { return query.getColumn(column).getString(); };
            all.push_back(
                {new_id(text(0)), {query.getColumn(1).getInt(), text(2), text(3), text(4), text(5), text(6), text(7)}});
        }
        return all;
    });
}

void Gradebook::put_reread(const KeptReread& kept, const Graded& before, const Graded& after, std::size_t place) {
    write([&] {
        const Author author{kept.given.by, kept.given.when};
        write_reread(*database_, kept);
        write_audit(*database_, author, reread_of(kept), line_of(before, kept.given), reread_text(kept.given));
        write_marked_again(before, after, place, author);
    });
}

void Gradebook::remove_reread(const KeptReread& removed, const Author& author, const std::string& why,
                              const Graded& before, const Graded& after, std::size_t place) {
    write([&] {
        erase_reread(removed, author, why);
        write_marked_again(before, after, place, author);
    });
}

void Gradebook::remove_reread(const KeptReread& removed, const Author& author, const std::string& why) {
    write([&] { erase_reread(removed, author, why); });
}

void Gradebook::erase_reread(const KeptReread& removed, const Author& author, const std::string& why) {
    erase_correction(*database_, "rereads", removed.submission, removed.given.question, removed.given.item);
    write_audit(*database_, author, reread_of(removed), reread_text(removed.given), "removed: " + why);
}

void Gradebook::write_marked_again(const Graded& before, const Graded& after, std::size_t place, const Author& author) {
    const std::int64_t run = last_run_number(*database_);
    SubmissionRows(*database_, run).write(after, place, to_record(after));
    if (is_same_mark(points_that_count(before), points_that_count(after))) return;
    write_audit(*database_, author, "mark of " + after.submission.id, mark_text_of(before), mark_text_of(after));
}

}  // namespace harness
