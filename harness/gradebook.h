// The gradebook: what a class was given, what its instructor gave instead, and who changed what when. One SQLite
// database, gradebook.sqlite, beside the reports, which are made from nothing else.
//
// Each change is one transaction, so that a run that is killed at any moment leaves the gradebook as it was before or
// as it is afterwards; reports that were not written any more are known and written by the next command. A gradebook
// that is damaged or of another version is refused and never replaced: overrides live in it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/author.h"
#include "harness/class_changes.h"
#include "harness/feedback_changes.h"
#include "harness/final_mark.h"
#include "harness/override_place.h"

namespace SQLite {
class Database;
}

namespace harness {

/// The gradebook's name in a folder of results.
constexpr const char* gradebook_name = "gradebook.sqlite";

/// One time that a class was graded and the results written.
struct Run {
    std::int64_t number = 0;  ///< from 1; given by the gradebook
    Author author;
    std::string raygrade;  ///< its version
    std::string assignment;
    std::filesystem::path assignment_file;
    std::string toml;  ///< the assignment's text
    Tier tier = Tier::bwrap;
};

/// A file that reports are made from beside the submissions, such as a gradebook exported from Canvas.
struct KeptInput {
    std::string name;    ///< "canvas-roster"
    std::string choice;  ///< what in it, such as its column
    std::string content;
};

/// To be used by one thread at a time.
class Gradebook {
  public:
    /// Opens the gradebook of a folder of results, if it has one; none is made before something is saved. Throws
    /// UsageError when it can't be used. All else throws HarnessError when the database fails.
    explicit Gradebook(const std::filesystem::path& folder);
    ~Gradebook();
    Gradebook(Gradebook&&) noexcept;

    /// The last one saved; empty before the first.
    std::optional<Run> last_run() const;
    /// Whether the files beside the gradebook tell all that is in it, so that no command was ended before.
    bool reports_are_written() const;
    void note_reports_written();

    /// The oldest first.
    std::vector<KeptOverride> overrides() const;
    /// The class as it was saved, in its order, without overrides.
    std::vector<Graded> restore() const;
    std::optional<KeptInput> input(const std::string& name) const;

    /// What a new grading of the class changes, and for save(), which submissions need not be written again.
    struct Comparison {
        enum class Record { same, other, other_marks, fresh };
        ClassChanges changes;
        FeedbackChanges feedback;
        std::vector<Record> records;  ///< by submission of the new grading
        std::int64_t run = 0;         ///< that it was compared with
        bool is_in_order = true;      ///< the submissions that are in both follow each other as before

        /// Saving it would change nothing of any submission.
        bool is_as_saved() const;
    };
    /// `graded` with its overrides. A small part of the gradebook at a time is in memory.
    Comparison compare(const std::vector<Graded>& graded) const;

    /// Puts the new grading in the place of the last one, whose marks go into the history. Inputs replace those
    /// of their name. Refused when another run was saved since the comparison.
    void save(const Run& run, const std::vector<Graded>& graded, const Comparison& comparison,
              const std::vector<KeptInput>& inputs);

    /// Takes the place of an earlier one of the same item. `automatic` are the points it replaces, `points` those of
    /// the submission that count now.
    void put_override(const KeptOverride& kept, double automatic, const std::optional<double>& points);
    /// The override itself stays in the audit trail, with who removed it and why.
    void remove_override(const KeptOverride& removed, const Author& author, const std::string& why,
                         const std::optional<double>& points);

  private:
    template <class Work>
    auto attempt(Work work) const -> decltype(work());
    std::filesystem::path file_;
    std::unique_ptr<SQLite::Database> database_;  ///< null while there is none
};

}  // namespace harness
