// The class under review. Several windows, and other commands, may change its gradebook at the same time: each request
// sees the gradebook's current state, and each change is made under the lock of the results folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/class_run/kept_class.h"
#include "harness/machine/errors.h"

namespace harness::review {

/// A submission in the state that a page showed.
struct Shown {
    std::string id;
    std::string state;  ///< Session::state_of
};

/// Another window, command or person changed something after the page was made.
class ChangedMeanwhile : public UsageError {
  public:
    /// `ids` are the submissions that changed or are gone.
    explicit ChangedMeanwhile(const std::vector<std::string>& ids);
};

class Session {
  public:
    /// `by` is the person who decides; if it is empty, the account that runs raygrade. Throws UsageError if the folder
    /// has no gradebook.
    Session(std::filesystem::path folder, std::string by);

    /// Reads the class again if the gradebook has changed. Throws UsageError and HarnessError; the class then stays
    /// unchanged.
    void refresh();

    // After a change that failed, call refresh() first.
    const KeptClass& kept() const { return kept_; }
    const std::vector<Graded>& graded() const { return kept_.graded; }
    const Marking& marking() const { return marking_; }
    /// The indices of the submissions whose outputs have the same layout as this one's, including its own. Empty if it
    /// printed nothing.
    std::vector<std::size_t> with_layout_of(std::size_t index) const;
    Author author() const { return author_of(by_); }

    /// Identifies the state of a submission's results and decisions. A form made for another state is refused.
    std::string state_of(std::size_t index) const;

    /// The indices of these submissions. Throws ChangedMeanwhile if any of them changed since the page was made.
    std::vector<std::size_t> indices_of(const std::vector<Shown>& shown) const;

    /// Changes the class: takes the lock, refreshes, calls `work`, and writes the reports of the submissions whose
    /// indices `work` returns. All changes of `work` to the gradebook are one transaction. Throws HarnessError, and
    /// UsageError, also if another raygrade has the lock.
    using Work = std::function<std::vector<std::size_t>(Gradebook& gradebook, KeptClass& kept)>;
    void change(const Work& work);

  private:
    void load_if_changed(const Gradebook& gradebook);
    void load(const Gradebook& gradebook);

    std::filesystem::path folder_;
    std::string by_;
    std::optional<std::string> version_;  ///< of the gradebook that was read; empty after a failed change
    KeptClass kept_;
    std::optional<Marking> by_names_;  ///< see marking_by_ids
    Marking marking_;
    std::vector<std::string> layouts_;  ///< of the outputs; empty for one that printed nothing
};

}  // namespace harness::review
