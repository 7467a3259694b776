#include "harness/shards/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include "harness/grade/grade_submission.h"
#include "harness/grade/reread.h"
#include "harness/machine/errors.h"
#include "harness/text/listed.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

struct GivenPart {
    fs::path file;
    PartHead head;
};

/// The problems of the parts, one per line.
class Complaints {
  public:
    void add(const fs::path& file, const std::string& what) { lines_ += fmt::format("\n  {} {}", file.string(), what); }
    void add(const std::string& what) { lines_ += "\n  " + what; }

    /// Throws UsageError if there are any.
    void raise() const {
        if (!lines_.empty()) throw UsageError("cannot merge these parts, so nothing was written:" + lines_);
    }

  private:
    std::string lines_;
};

std::vector<GivenPart> read_heads(const std::vector<fs::path>& files, Complaints& complaints) {
    std::vector<GivenPart> given;
    for (const fs::path& file : files) {
        try {
            given.push_back({file, read_part_head(file)});
        } catch (const DamagedFile& damage) {
            complaints.add(file, damage.what());
        }
    }
    return given;
}

/// Everything that must be equal in all parts of one grading.
std::string common(const PartHead& head) {
    return fmt::format("{} {} {}", head.shard.count, head.class_size, head.alike.dump());
}

/// The part that agrees with the most others, so that a message names the one that differs and not all others.
const GivenPart& most_common(const std::vector<GivenPart>& given) {
    std::map<std::string, int> counts;
    for (const GivenPart& given_part : given) ++counts[common(given_part.head)];
    return *std::ranges::max_element(given, {}, [&](const GivenPart& each) { return counts[common(each.head)]; });
}

/// A clause about the first difference.
std::string difference(const PartHead& part_head, const GivenPart& most) {
    for (const auto& [what, value] : part_head.alike.items()) {
        const auto here = value.get<std::string>(), there = most.head.alike.value(what, std::string());
        if (here == there) continue;
        constexpr std::size_t longest_shown = 40;  // shorter than a fingerprint
        const bool is_shown = std::max(here.size(), there.size()) < longest_shown;
        const std::string values = is_shown ? fmt::format(" ({}, not {})", here, there) : "";
        return fmt::format("was graded with a different {} than {}{}; grade it again like the others", what,
                           most.file.string(), values);
    }
    if (part_head.shard.count != most.head.shard.count) {
        return fmt::format("is one of {} parts, but {} is one of {}; grade it again like the others",
                           part_head.shard.count, most.file.string(), most.head.shard.count);
    }
    return fmt::format("belongs to a different class than {}; leave it out", most.file.string());
}

void require_all_once(const std::vector<GivenPart>& given, int count, Complaints& complaints) {
    std::map<int, fs::path> found;
    for (const GivenPart& given_part : given) {
        const auto [at, is_new] = found.emplace(given_part.head.shard.number, given_part.file);
        if (is_new) continue;
        complaints.add(given_part.file, fmt::format("is part {} of {}, and so is {}; leave one out",
                                                    given_part.head.shard.number, count, at->second.string()));
    }
    std::vector<std::string> missing;
    for (int number = 1; number <= count; ++number) {
        if (!found.contains(number)) missing.push_back(std::to_string(number));
    }
    if (missing.empty()) return;
    complaints.add(fmt::format("missing: {} {} of {}; grade {} with --shard", missing.size() == 1 ? "part" : "parts",
                               listed(missing), count, missing.size() == 1 ? "it" : "them"));
}

void require_that_fit(std::vector<GivenPart>& given, Complaints& complaints) {
    const GivenPart most = most_common(given);
    if (most.head.alike.value("raygrade", "") != RAYGRADE_VERSION) {
        complaints.add(
            most.file,
            fmt::format(
                "was graded by a different version of raygrade; this is {}. Grade or merge with the same version",
                RAYGRADE_VERSION));
        return;
    }
    std::erase_if(given, [&](const GivenPart& given_part) {
        if (common(given_part.head) == common(most.head)) return false;
        complaints.add(given_part.file, difference(given_part.head, most));
        return true;
    });
    require_all_once(given, most.head.shard.count, complaints);
}

/// Puts a part's submissions at their places in the class.
void add_part(Part& part, const fs::path& file, std::vector<IndexedGraded>& graded, std::set<std::string>& ids,
              Complaints& complaints) {
    for (IndexedGraded& indexed_graded : part.graded) {
        IndexedGraded& there = graded[indexed_graded.index];
        if (!there.graded.submission.id.empty() || !ids.insert(indexed_graded.graded.submission.id).second) {
            complaints.add(file, fmt::format("contains {}, and so does another part; leave one out",
                                             in_quotes(indexed_graded.graded.submission.id)));
            return;
        }
        there = std::move(indexed_graded);
    }
}

/// Whether the result was marked with exactly these rereads.
bool is_marked_with(const Graded& graded, const std::vector<Reread>& rereads) {
    std::ptrdiff_t marked = 0, count = 0;
    for (const QuestionScore& question : graded.score.questions)
        marked += std::ranges::count_if(question.items, [](const ItemScore& item) { return !item.reread.empty(); });
    const std::string layout = rereads.empty() ? "" : layout_of(graded.execution.printout);
    for (const Reread& reread : rereads) {
        if (reread.layout != layout) continue;
        if (!counts(graded, reread)) return false;
        ++count;
    }
    return marked == count;
}

}  // namespace

Part merge_parts(const std::vector<fs::path>& files) {
    Complaints complaints;
    std::vector<GivenPart> given = read_heads(files, complaints);
    if (!given.empty()) require_that_fit(given, complaints);
    complaints.raise();

    Part merged;
    std::vector<IndexedGraded> graded(given.front().head.class_size);
    std::set<std::string> ids;
    for (const GivenPart& given_part : given) {
        try {
            Part part = read_part(given_part.file);
            if (common(part.head) != common(given_part.head) || part.head.shard.number != given_part.head.shard.number)
                throw DamagedFile("changed while it was read");
            add_part(part, given_part.file, graded, ids, complaints);
            part.graded.clear();
            if (&given_part == &given.front()) merged = std::move(part);
        } catch (const DamagedFile& damage) {
            complaints.add(given_part.file, fmt::format("{}; grade it again with --shard {}/{}", damage.what(),
                                                        given_part.head.shard.number, given_part.head.shard.count));
        }
    }
    complaints.raise();
    if (ids.size() != graded.size())
        complaints.add("some submissions of the class are in no part; grade all parts again");
    complaints.raise();
    merged.graded = std::move(graded);
    return merged;
}

std::vector<Submission> submissions_of(const Part& merged) {
    std::vector<Submission> submissions;
    for (const IndexedGraded& indexed_graded : merged.graded) {
        const Submission& from = indexed_graded.graded.submission;
        Submission& submission = submissions.emplace_back();
        submission.id = from.id;
        submission.lms = from.lms;
    }
    return submissions;
}

std::vector<Graded> results_of(std::vector<Submission> submissions, Part& merged, const Marking& marking) {
    std::unordered_map<std::string, Graded*> by_id;
    for (IndexedGraded& indexed_graded : merged.graded)
        by_id.emplace(indexed_graded.graded.submission.id, &indexed_graded.graded);
    std::vector<Graded> results;
    results.reserve(submissions.size());
    for (Submission& submission : submissions) {
        Graded& graded = results.emplace_back(std::move(*by_id.at(submission.id)));
        graded.submission.name = std::move(submission.name);
        graded.submission.rereads = std::move(submission.rereads);
        if (!graded.execution.printout.empty() && !is_marked_with(graded, graded.submission.rereads))
            mark_again(graded, marking);
    }
    merged.graded = {};  // frees the memory, which clear() does not
    return results;
}

}  // namespace harness
