#include "harness/gradebook/gradebook.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "harness/gradebook/database.h"
#include "harness/gradebook/record.h"
#include "harness/gradebook/rows.h"
#include "harness/machine/errors.h"
#include "harness/record/final_mark.h"
#include "harness/text/points.h"

namespace harness {
namespace {

using SQLite::Statement;

using Record = Gradebook::Comparison::Record;

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
};

/// Whether the records differ only in the folders or the archive of the file. Each download from an LMS has a new name.
bool differs_in_folder_only(const std::vector<std::uint8_t>& kept, const Graded& before, const Graded& after) {
    const std::filesystem::path& file = before.submission.file;
    if (file == after.submission.file || file.filename() != after.submission.file.filename()) return false;
    Graded there = after;
    there.submission.file = file;
    return to_record(there) == kept;
}

/// Empty if the kept record is damaged. Adds differences other than marks to `feedback`.
std::optional<Compared> compare_one(const std::vector<std::uint8_t>& kept, const Graded& after,
                                    FeedbackChanges& feedback) {
    Compared compared;
    if (kept == to_record(after)) return compared;
    auto before = from_record(kept);
    if (!before) return std::nullopt;
    if (differs_in_folder_only(kept, *before, after)) return compared;
    before->review.overrides = after.review.overrides;
    const MarkChange& change = compared.change.emplace(change_between(*before, after));
    const bool moved = !change.reasons.empty() || !is_same_mark(change.before, change.after);
    compared.record = moved ? Record::other_marks : Record::other;
    add_feedback(feedback, *before, after, moved ? Marks::moved : Marks::same);
    return compared;
}

}  // namespace

Gradebook::Gradebook(const std::filesystem::path& folder)
    : file_(folder / gradebook_name), database_(open_gradebook(file_, Create::no)) {}

Gradebook::~Gradebook() = default;
Gradebook::Gradebook(Gradebook&&) noexcept = default;

std::optional<Run> Gradebook::last_run() const {
    if (!database_) return std::nullopt;
    return in_database(file_, [&]() -> std::optional<Run> {
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
    return in_database(file_, [&] {
        return database_->execAndGet("SELECT entry = (SELECT COALESCE(MAX(entry), 0) FROM audit) FROM reports")
                   .getInt() != 0;
    });
}

void Gradebook::note_reports_written() {
    if (!database_) return;
    in_database(file_,
                [&] { database_->exec("UPDATE reports SET entry = (SELECT COALESCE(MAX(entry), 0) FROM audit)"); });
}

std::string Gradebook::feedback_of_pages() const {
    if (!database_) return "";
    return in_database(file_, [&]() -> std::string {
        Statement query(*database_, "SELECT feedback FROM pages");
        return query.executeStep() ? query.getColumn(0).getString() : "";
    });
}

void Gradebook::note_feedback_of_pages(std::string_view feedback) {
    if (!database_) return;
    write([&] {
        database_->exec("DELETE FROM pages");
        execute(*database_, "INSERT INTO pages VALUES (?)", feedback);
    });
}

void Gradebook::go_by_number(const std::vector<Submission>& submissions) {
    new_ids_.clear();
    if (!database_) return;
    std::map<std::string, std::string> id_of_number, number_of_id;
    for (const Submission& submission : submissions) {
        // Gradescope numbers submissions, not students.
        if (!submission.lms || submission.lms->system == Lms::gradescope) continue;
        id_of_number[submission.lms->id] = submission.id;
        number_of_id[submission.id] = submission.lms->id;
    }
    in_database(file_, [&] {
        Statement query(
            *database_,
            "SELECT id, lms_id FROM submissions WHERE lms_id IS NOT NULL UNION SELECT submission, lms_id FROM numbers");
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

/// The id under which the gradebook keeps a submission; empty if another student has this id.
std::string Gradebook::kept_id(const std::string& id) const {
    const auto found =
        std::find_if(new_ids_.begin(), new_ids_.end(), [&](const auto& change) { return change.second == id; });
    if (found != new_ids_.end()) return found->first;
    return new_ids_.contains(id) ? "" : id;
}

std::vector<Graded> Gradebook::restore() const {
    if (!database_) return {};
    return in_database(file_, [&] {
        Statement query(*database_,
                        "SELECT id, record, output, source FROM submissions LEFT JOIN printouts ON "
                        "printouts.submission = id LEFT JOIN sources ON sources.submission = id ORDER BY place");
        std::vector<Graded> graded;
        while (query.executeStep()) {
            auto one = from_record(bytes_of(query.getColumn(1)));
            if (!one) throw HarnessError(gradebook_damage(file_, "the record of " + query.getColumn(0).getString()));
            one->execution.printout = query.getColumn(2).getString();
            one->submission.source = query.getColumn(3).getString();
            graded.push_back(std::move(*one));
        }
        return graded;
    });
}

std::optional<KeptInput> Gradebook::input(const std::string& name) const {
    if (!database_) return std::nullopt;
    return in_database(file_, [&]() -> std::optional<KeptInput> {
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
    const auto add_fresh = [&](const Graded& result) {
        comparison.changes.fresh.push_back(
            {result.submission.id, label_of(result.submission), std::nullopt, points_that_count(result), {}});
    };
    if (!database_) {
        std::for_each(graded.begin(), graded.end(), add_fresh);
        return comparison;
    }
    return in_database(file_, [&] {
        // A transaction, so that all reads see the same state even if another program writes meanwhile.
        const SQLite::Transaction view(*database_);
        comparison.run = last_run_number(*database_);
        // A gradebook from an older raygrade has no outputs or no sources.
        Statement find(*database_,
                       "SELECT record, place, EXISTS (SELECT 1 FROM printouts WHERE submission = id), "
                       "EXISTS (SELECT 1 FROM sources WHERE submission = id) "
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
            auto compared = compare_one(bytes_of(find.getColumn(0)), one, comparison.feedback);
            if (!compared) throw HarnessError(gradebook_damage(file_, "the record of " + one.submission.id));
            const bool has_printout = find.getColumn(2).getInt() != 0 || one.execution.printout.empty();
            const bool has_source = find.getColumn(3).getInt() != 0 || one.submission.source.empty();
            if (compared->record == Record::same && !(has_printout && has_source)) compared->record = Record::other;
            comparison.records[i] = compared->record;
            if (compared->change) {
                add(comparison.changes, std::move(*compared->change));
            } else {
                ++comparison.changes.untouched;
            }
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
                {id, id, mark.isNull() ? std::nullopt : std::optional(mark.getDouble()), std::nullopt, {}});
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
    in_database(file_, [&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        Run numbered = run;
        numbered.number = last_run_number(*database_) + 1;
        if (numbered.number != comparison.run + 1) {
            throw HarnessError(fmt::format(
                "another raygrade changed {} at the same time, so nothing was written; run the command again",
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

}  // namespace harness
