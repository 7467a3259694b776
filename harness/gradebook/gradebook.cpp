#include "harness/gradebook/gradebook.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <unordered_set>
#include <utility>

#include "harness/grade/final_mark.h"
#include "harness/gradebook/database.h"
#include "harness/gradebook/record.h"
#include "harness/gradebook/rows.h"
#include "harness/machine/errors.h"
#include "harness/text/points.h"

namespace harness {
namespace {

using SQLite::Statement;

using Record = Gradebook::Comparison::Record;

constexpr const char* last_run_number = "SELECT COALESCE(MAX(run), 0) FROM runs";

std::vector<std::uint8_t> bytes(const SQLite::Column& column) {
    const auto* begin = static_cast<const std::uint8_t*>(column.getBlob());
    return {begin, begin + column.getBytes()};
}

Tier tier_called(const std::string& name) {
    for (const Tier tier : {Tier::bwrap, Tier::landlock}) {
        if (to_string(tier) == name) return tier;
    }
    return Tier::unsafe;
}

/// The comparison of a submission in both gradings.
struct Compared {
    Record record = Record::same;
    std::optional<MarkChange> change;  ///< empty if the record is the same
    FeedbackChanges feedback;
};

/// Empty if the kept record is damaged.
std::optional<Compared> compare_one(const std::vector<std::uint8_t>& kept, const Graded& after) {
    Compared compared;
    if (kept == to_record(after)) return compared;
    auto before = from_record(kept);
    if (!before) return std::nullopt;
    before->overrides = after.overrides;
    const MarkChange& change = compared.change.emplace(change_between(*before, after));
    const bool moved = !change.reasons.empty() || !is_same_mark(change.before, change.after);
    compared.record = moved ? Record::other_marks : Record::other;
    add_feedback(compared.feedback, *before, after, moved ? Marks::moved : Marks::same);
    return compared;
}

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

/// Where the item was read from: "line 12"; nothing if it was not found.
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

std::string account_name() {
    const passwd* account = getpwuid(geteuid());
    return account == nullptr ? fmt::format("user {}", geteuid()) : account->pw_name;
}

}  // namespace

Author author_now(const std::string& name) {
    return {name.empty() ? account_name() : name,
            fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))};
}

Gradebook::Gradebook(const std::filesystem::path& folder)
    : file_(folder / gradebook_name), database_(open_gradebook(file_, Create::no)) {}

Gradebook::~Gradebook() = default;
Gradebook::Gradebook(Gradebook&&) noexcept = default;

template <class Work>
auto Gradebook::attempt(Work work) const -> decltype(work()) {
    try {
        return work();
    } catch (const SQLite::Exception& error) {
        throw HarnessError(gradebook_problem(file_, error));
    }
}

std::optional<Run> Gradebook::last_run() const {
    if (!database_) return std::nullopt;
    return attempt([&]() -> std::optional<Run> {
        Statement query(*database_,
                        "SELECT run, who, at, raygrade, assignment, assignment_file, toml, sandbox FROM runs "
                        "ORDER BY run DESC LIMIT 1");
        if (!query.executeStep()) return std::nullopt;
        const auto text = [&](int column) { return query.getColumn(column).getString(); };
        return Run{query.getColumn(0).getInt64(), {text(1), text(2)}, text(3), text(4), text(5), text(6),
                   tier_called(text(7))};
    });
}

bool Gradebook::reports_are_written() const {
    if (!database_) return true;
    return attempt([&] {
        return database_->execAndGet("SELECT entry = (SELECT COALESCE(MAX(entry), 0) FROM audit) FROM reports")
                   .getInt() != 0;
    });
}

void Gradebook::note_reports_written() {
    if (!database_) return;
    attempt([&] { database_->exec("UPDATE reports SET entry = (SELECT COALESCE(MAX(entry), 0) FROM audit)"); });
}

void Gradebook::go_by_number(const std::vector<Submission>& submissions) {
    new_ids_.clear();
    if (!database_) return;
    std::map<std::string, std::string> id_of_number, number_of_id;
    for (const Submission& one : submissions) {
        // Gradescope numbers hand-ins, not students.
        if (!one.lms || one.lms->system == Lms::gradescope) continue;
        id_of_number[one.lms->id] = one.id;
        number_of_id[one.id] = one.lms->id;
    }
    attempt([&] {
        Statement query(*database_, "SELECT id, lms_id FROM submissions WHERE lms_id IS NOT NULL");
        while (query.executeStep()) {
            const std::string id = query.getColumn(0).getString(), number = query.getColumn(1).getString();
            const auto now = id_of_number.find(number);
            const auto taken = number_of_id.find(id);
            if (now != id_of_number.end()) {
                if (now->second != id) new_ids_[id] = now->second;
            } else if (taken != number_of_id.end()) {
                new_ids_[id] = id + "_" + number;
            }
        }
    });
}

std::string Gradebook::new_id(const std::string& kept) const {
    const auto found = new_ids_.find(kept);
    return found == new_ids_.end() ? kept : found->second;
}

/// The id under which a submission is kept; one that nothing has if its own is that of another student.
std::string Gradebook::kept_id(const std::string& id) const {
    const auto found =
        std::find_if(new_ids_.begin(), new_ids_.end(), [&](const auto& change) { return change.second == id; });
    if (found != new_ids_.end()) return found->first;
    return new_ids_.contains(id) ? "" : id;
}

std::vector<KeptOverride> Gradebook::overrides() const {
    if (!database_) return {};
    return attempt([&] {
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

std::vector<Graded> Gradebook::restore() const {
    if (!database_) return {};
    return attempt([&] {
        Statement query(*database_, "SELECT id, record FROM submissions ORDER BY place");
        std::vector<Graded> graded;
        while (query.executeStep()) {
            auto one = from_record(bytes(query.getColumn(1)));
            if (!one) throw HarnessError(gradebook_damage(file_, "the record of " + query.getColumn(0).getString()));
            graded.push_back(std::move(*one));
        }
        return graded;
    });
}

std::optional<KeptInput> Gradebook::input(const std::string& name) const {
    if (!database_) return std::nullopt;
    return attempt([&]() -> std::optional<KeptInput> {
        Statement query(*database_, "SELECT choice, content FROM inputs WHERE name = ?");
        query.bind(1, name);
        if (!query.executeStep()) return std::nullopt;
        return KeptInput{name, query.getColumn(0).getString(), query.getColumn(1).getString()};
    });
}

bool Gradebook::Comparison::is_as_saved() const {
    return is_in_order && changes.gone.empty() &&
           std::all_of(records.begin(), records.end(), [](Record record) { return record == Record::same; });
}

Gradebook::Comparison Gradebook::compare(const std::vector<Graded>& graded) const {
    Comparison comparison;
    comparison.records.assign(graded.size(), Record::fresh);
    const auto add_fresh = [&](const Graded& one) {
        comparison.changes.fresh.push_back({one.submission.id, std::nullopt, points_that_count(one), {}});
    };
    if (!database_) {
        std::for_each(graded.begin(), graded.end(), add_fresh);
        return comparison;
    }
    return attempt([&] {
        // A transaction, so that all reads see the same state even if another program writes meanwhile.
        const SQLite::Transaction view(*database_);
        comparison.run = database_->execAndGet(last_run_number).getInt64();
        // A gradebook that an older raygrade wrote has no printouts.
        Statement find(*database_,
                       "SELECT record, place, EXISTS (SELECT 1 FROM printouts WHERE submission = id) "
                       "FROM submissions WHERE id = ?");
        std::unordered_set<std::string> present;
        std::int64_t last_place = -1;
        for (std::size_t i = 0; i < graded.size(); ++i) {
            const Graded& one = graded[i];
            present.insert(one.submission.id);
            find.reset();
            find.bind(1, kept_id(one.submission.id));
            if (!find.executeStep()) {
                add_fresh(one);
                continue;
            }
            auto compared = compare_one(bytes(find.getColumn(0)), one);
            if (!compared) throw HarnessError(gradebook_damage(file_, "the record of " + one.submission.id));
            const bool has_printout = find.getColumn(2).getInt() != 0 || one.printout.empty();
            if (compared->record == Record::same && !has_printout) compared->record = Record::other;
            comparison.records[i] = compared->record;
            if (compared->change) {
                add(comparison.changes, std::move(*compared->change));
            } else {
                ++comparison.changes.untouched;
            }
            add(comparison.feedback, compared->feedback);
            const std::int64_t place = find.getColumn(1).getInt64();
            if (place <= last_place) comparison.is_in_order = false;
            last_place = place;
        }
        Statement all(*database_, "SELECT id, final_points FROM submissions ORDER BY place");
        while (all.executeStep()) {
            const std::string id = new_id(all.getColumn(0).getString());
            const SQLite::Column mark = all.getColumn(1);
            if (present.contains(id)) continue;
            comparison.changes.gone.push_back(
                {id, mark.isNull() ? std::nullopt : std::optional(mark.getDouble()), std::nullopt, {}});
        }
        return std::move(comparison);
    });
}

void Gradebook::save(const Run& run, const std::vector<Graded>& graded, const Comparison& comparison,
                     const std::vector<KeptInput>& inputs) {
    if (!database_) {
        try {
            database_ = open_gradebook(file_, Create::yes);
        } catch (const UsageError& error) {  // a HarnessError, because the class has already been graded
            throw HarnessError(error.what());
        }
    }
    attempt([&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        Run numbered = run;
        numbered.number = database_->execAndGet(last_run_number).getInt64() + 1;
        if (numbered.number != comparison.run + 1) {
            throw HarnessError(
                fmt::format("{}: was changed by another raygrade meanwhile, so nothing was written; "
                            "run the command again",
                            file_.string()));
        }
        rename_submissions(*database_, new_ids_, run.author);
        write_run(*database_, numbered, graded);
        SubmissionRows rows(*database_, numbered.number);
        for (const MarkChange& change : comparison.changes.gone) {
            rows.remove(change.id);
            rows.add_gone(change.id);
        }
        for (std::size_t i = 0; i < graded.size(); ++i) {
            const Record record = comparison.records[i];
            if (record == Record::same) {
                rows.move(graded[i].submission.id, i);
                continue;
            }
            rows.write(graded[i], i, to_record(graded[i]));
            if (record != Record::other) rows.add_history(graded[i]);
        }
        for (const KeptInput& input : inputs) write_input(*database_, input);
        write_changes(*database_, numbered, comparison.changes);
        transaction.commit();
        new_ids_.clear();
    });
}

void Gradebook::put_override(const KeptOverride& kept, double automatic, const std::optional<double>& points) {
    attempt([&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        std::string before = fmt::format("{}, automatically", points_text(automatic));
        for (const KeptOverride& each : overrides()) {
            if (is_same_place(each, kept)) before = override_text(each.given);
        }
        write_override(*database_, kept);
        write_final_points(*database_, kept.submission, points);
        write_audit(*database_, {kept.given.by, kept.given.when}, override_of(kept), before, override_text(kept.given));
        transaction.commit();
    });
}

void Gradebook::remove_override(const KeptOverride& removed, const Author& author, const std::string& why,
                                const std::optional<double>& points) {
    attempt([&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        erase_correction(*database_, "overrides", removed.submission, removed.given.question, removed.given.item);
        write_final_points(*database_, removed.submission, points);
        write_audit(*database_, author, override_of(removed), override_text(removed.given), "removed: " + why);
        transaction.commit();
    });
}

std::vector<KeptReread> Gradebook::rereads() const {
    if (!database_) return {};
    return attempt([&] {
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

std::string Gradebook::printout(const std::string& submission) const {
    if (!database_) return {};
    return attempt([&]() -> std::string {
        Statement query(*database_, "SELECT output FROM printouts WHERE submission = ?");
        query.bind(1, submission);
        if (!query.executeStep()) return {};
        const std::vector<std::uint8_t> output = bytes(query.getColumn(0));
        return {output.begin(), output.end()};
    });
}

void Gradebook::put_reread(const KeptReread& kept, const Graded& before, const Graded& after, std::size_t place) {
    attempt([&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        const Author author{kept.given.by, kept.given.when};
        write_reread(*database_, kept);
        write_audit(*database_, author, reread_of(kept), line_of(before, kept.given), reread_text(kept.given));
        write_marked_again(before, after, place, author);
        transaction.commit();
    });
}

void Gradebook::remove_reread(const KeptReread& removed, const Author& author, const std::string& why,
                              const Graded& before, const Graded& after, std::size_t place) {
    attempt([&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        erase_reread(removed, author, why);
        write_marked_again(before, after, place, author);
        transaction.commit();
    });
}

void Gradebook::remove_reread(const KeptReread& removed, const Author& author, const std::string& why) {
    attempt([&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        erase_reread(removed, author, why);
        transaction.commit();
    });
}

void Gradebook::erase_reread(const KeptReread& removed, const Author& author, const std::string& why) {
    erase_correction(*database_, "rereads", removed.submission, removed.given.question, removed.given.item);
    write_audit(*database_, author, reread_of(removed), reread_text(removed.given), "removed: " + why);
}

void Gradebook::write_marked_again(const Graded& before, const Graded& after, std::size_t place, const Author& author) {
    const std::int64_t run = database_->execAndGet(last_run_number).getInt64();
    SubmissionRows(*database_, run).write(after, place, to_record(after));
    if (is_same_mark(points_that_count(before), points_that_count(after))) return;
    write_audit(*database_, author, "mark of " + after.submission.id, mark_text_of(before), mark_text_of(after));
}

}  // namespace harness
