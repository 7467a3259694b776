// Splits a class among machines. Each machine computes the same split on its own, from the sources alone.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "harness/intake/submission.h"

namespace harness {

/// One share of a class: "3/16".
struct Shard {
    static constexpr int most = 10000;

    int number = 1;  ///< 1 to `count`
    int count = 1;   ///< 1 to `most`
};

/// Empty if the text is not a share.
std::optional<Shard> read_shard(std::string_view text);

/// The number of the shard of each submission, 1 to `count`. Equal sources go to the same shard, and sources with the
/// same precompiled header go to as few shards as possible, so that few machines make it. Within that, shards have
/// nearly equal sizes; a shard may be empty. The names and the order of the submissions do not matter.
std::vector<int> split(const std::vector<Submission>& submissions, int count);

}  // namespace harness
