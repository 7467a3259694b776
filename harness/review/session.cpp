#include "harness/review/session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "harness/grade/reread.h"
#include "harness/gradebook/record.h"
#include "harness/machine/errors.h"
#include "harness/machine/fingerprint.h"
#include "harness/machine/fresh_file.h"
#include "harness/record/concerns.h"

namespace harness::review {
namespace {

namespace fs = std::filesystem;

}  // namespace

ChangedMeanwhile::ChangedMeanwhile(const std::vector<std::string>& ids)
    : UsageError(
          fmt::format("{} changed since this page was loaded, so nothing was done. The page now shows the new state; "
                      "decide again if it is still right.",
                      fmt::join(ids, ", "))) {}

Session::Session(fs::path folder, std::string by) : folder_(std::move(folder)), by_(std::move(by)) {
    refresh();
    author();  // so that an unusable name is reported at once
}

void Session::refresh() {
    load_if_changed(Gradebook(folder_));
}

void Session::load_if_changed(const Gradebook& gradebook) {
    if (version_ != gradebook.version()) load(gradebook);
}

void Session::load(const Gradebook& gradebook) {
    std::string version = gradebook.version();
    KeptClass kept = restore(gradebook, folder_);
    Marking by_names = by_names_ && kept.run.toml == kept_.run.toml ? *by_names_ : marking_by_names(kept.run);
    Marking marking = marking_by_ids(by_names, kept.graded);
    std::vector<std::string> layouts;
    for (const Graded& graded : kept.graded)
        layouts.push_back(graded.execution.printout.empty() ? "" : layout_of(graded.execution.printout));

    kept_ = std::move(kept);
    by_names_ = std::move(by_names);
    marking_ = std::move(marking);
    layouts_ = std::move(layouts);
    version_ = std::move(version);
}

std::vector<std::size_t> Session::with_layout_of(std::size_t index) const {
    std::vector<std::size_t> alike;
    for (std::size_t i = 0; i < layouts_.size(); ++i) {
        if (!layouts_[i].empty() && layouts_[i] == layouts_[index]) alike.push_back(i);
    }
    return alike;
}

std::string Session::state_of(std::size_t index) const {
    const Graded& result = graded()[index];
    const std::vector<std::uint8_t> record = to_record(result);
    Fingerprint state("raygrade/review-state/1");
    state.add(std::string(record.begin(), record.end()));
    for (const Override& given : result.review.overrides)
        state.add(fmt::format("{} {} {} {} {}", place_of(given), given.points, given.when, given.by, given.why));
    for (const Reread& reread : result.submission.rereads)
        state.add(fmt::format("{} {} {} {} {} {}", reread.question, reread.item, reread.lines, reread.when, reread.by,
                              reread.why));
    for (const Decision& decision : result.review.decisions)
        state.add(fmt::format("{} {} {}", decision.number, to_string(decision.kind), decision.about));
    constexpr std::size_t enough = 32;
    return state.hex().substr(0, enough);
}

std::vector<std::size_t> Session::indices_of(const std::vector<Shown>& shown) const {
    std::map<std::string, std::size_t> place_of_id;
    for (std::size_t i = 0; i < graded().size(); ++i) place_of_id[graded()[i].submission.id] = i;
    std::vector<std::size_t> indices;
    std::vector<std::string> changed;
    for (const Shown& each : shown) {
        const auto found = place_of_id.find(each.id);
        if (found == place_of_id.end() || state_of(found->second) != each.state) {
            changed.push_back(each.id);
        } else {
            indices.push_back(found->second);
        }
    }
    if (!changed.empty()) throw ChangedMeanwhile(changed);
    return indices;
}

void Session::change(const Work& work) {
    const FolderLock lock(folder_);
    Gradebook gradebook(folder_);
    load_if_changed(gradebook);
    const bool as_left = reports_are_as_left(gradebook, kept_.graded, marking_, folder_);
    std::vector<std::size_t> changed;
    try {
        gradebook.together([&] { changed = work(gradebook, kept_); });
    } catch (...) {
        version_.reset();  // the change may be incomplete
        throw;
    }
    kept_.decisions = gradebook.decisions();
    kept_.undone = gradebook.undone_decisions();
    attach(kept_.decisions, kept_.graded);
    version_ = gradebook.version();
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    rewrite_reports(gradebook, kept_, marking_, as_left, changed, folder_);
}

}  // namespace harness::review
