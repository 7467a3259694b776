// The gradebook: the marks of a class, the instructor's overrides, and who changed what when. It is one SQLite
// database, gradebook.sqlite, in the folder of the reports. Reports use only this database.
//
// Each change is one transaction, so a run that is killed leaves the gradebook either as it was before or as it is
// afterwards. The gradebook notes which reports are still to be written; the next command writes them. A gradebook that
// is damaged or of another version is refused and never replaced, because it contains the overrides.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/gradebook/author.h"
#include "harness/gradebook/changed_feedback.h"
#include "harness/gradebook/changed_marks.h"
#include "harness/gradebook/run.h"
#include "harness/record/final_mark.h"
#include "harness/record/override_place.h"

namespace SQLite {
class Database;
}

namespace harness {

/// The gradebook's name in a folder of results.
constexpr const char* gradebook_name = "gradebook.sqlite";

/// A decision that no longer counts, and who undid it.
struct UndoneDecision {
    KeptDecision made;
    Author undone;
};

/// Only one thread at a time may use it.
class Gradebook {
  public:
    /// Opens the gradebook of a folder of results, if it has one; a gradebook is only created by save(). Throws
    /// UsageError if it can't be used. All other members throw HarnessError if the database fails.
    explicit Gradebook(const std::filesystem::path& folder);
    ~Gradebook();
    Gradebook(Gradebook&&) noexcept;

    /// The run saved last; empty if none was saved.
    std::optional<Run> last_run() const;
    /// Whether all reports were written after the last change to the gradebook. False if a command was interrupted.
    bool reports_are_written() const;
    void note_reports_written();
    /// The feedback level of the students' pages when all of them were last written: "hint". Empty if unknown.
    std::string feedback_of_pages() const;
    void note_feedback_of_pages(std::string_view feedback);

    /// Identifies students' kept data by the learning management system's number from now on, if these submissions have
    /// one. A student of the same name changes ids ("doejane" becomes "doejane_1001"), and a submission may get an id
    /// that belonged to another. All other members then use the ids of these submissions; save() writes them.
    void go_by_number(const std::vector<Submission>& submissions);

    /// All overrides, the oldest first.
    std::vector<KeptOverride> overrides() const;
    /// The class in the order in which it was saved, with outputs and sources and without overrides.
    std::vector<Graded> restore() const;
    std::optional<KeptInput> input(const std::string& name) const;

    /// The changes that a new grading of the class makes. It also tells save() which submissions need not be written
    /// again.
    struct Comparison {
        enum class Record { same, other, other_marks, fresh };
        ClassChanges changes;
        FeedbackChanges feedback;
        std::vector<Record> records;  ///< one for each submission of the new grading
        std::int64_t run = 0;         ///< the number of the run that it was compared with
        bool is_in_order = true;      ///< the submissions in both gradings are in the same order

        /// Whether saving the new grading would change no submission.
        bool is_as_saved() const;
    };
    /// `graded` includes its overrides. Only a small part of the gradebook is in memory at a time.
    Comparison compare(const std::vector<Graded>& graded) const;

    /// Replaces the last grading by the new one; the history keeps the marks of both. Each input replaces the one of
    /// the same name. Throws if another run was saved since the comparison.
    void save(const Run& run, const std::vector<Graded>& graded, const Comparison& comparison,
              const std::vector<KeptInput>& inputs);

    /// Saves an override, which replaces an earlier one of the same item. `automatic` are the points it overrides;
    /// `points` are the points of the submission that now count.
    void put_override(const KeptOverride& kept, double automatic, const std::optional<double>& points);
    /// Removes an override. The audit trail keeps it, with who removed it and why.
    void remove_override(const KeptOverride& removed, const Author& author, const std::string& why,
                         const std::optional<double>& points);

    /// All rereads, the oldest first.
    std::vector<KeptReread> rereads() const;
    /// Saves a reread, which replaces an earlier one of the same item, or removes it. `before` and `after` are the
    /// submission as marked before and after the change; `after` keeps its place in the class.
    void put_reread(const KeptReread& kept, const Graded& before, const Graded& after, std::size_t place);
    void remove_reread(const KeptReread& removed, const Author& author, const std::string& why, const Graded& before,
                       const Graded& after, std::size_t place);
    /// Removes the reread of a submission that is not in the class.
    void remove_reread(const KeptReread& removed, const Author& author, const std::string& why);

    /// The decisions of reviews that were not undone, oldest first. Decisions made together have the same number.
    std::vector<KeptDecision> decisions() const;
    /// The undone decisions, oldest first, without the decisions they replaced.
    std::vector<UndoneDecision> undone_decisions() const;
    /// The number for the next decision.
    std::int64_t next_decision() const;
    /// Saves a decision. Its override or reread is saved separately.
    void put_decision(const KeptDecision& kept);
    /// Marks a decision as undone. Does nothing if it is already undone.
    void undo_decision(const KeptDecision& kept, const Author& author);

    /// Differs after every change, and from all versions of a gradebook that was recreated in the same place. Empty if
    /// there is no gradebook yet.
    std::string version() const;
    /// Runs all changes of `changes` in one transaction: if it throws, none of them is saved.
    void together(const std::function<void()>& changes);

  private:
    void write(const std::function<void()>& change);
    std::string new_id(const std::string& kept) const;
    std::string kept_id(const std::string& id) const;
    void erase_reread(const KeptReread& removed, const Author& author, const std::string& why);
    void write_marked_again(const Graded& before, const Graded& after, std::size_t place, const Author& author);
    std::filesystem::path file_;
    std::unique_ptr<SQLite::Database> database_;  ///< null until there is one
    std::map<std::string, std::string> new_ids_;  ///< by the kept ids that change
    bool in_transaction_ = false;
};

}  // namespace harness
