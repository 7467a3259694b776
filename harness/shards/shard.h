// How a class is split among machines. Each machine computes the same split by itself, from the sources alone.
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

/// Empty if the text is no share.
std::optional<Shard> read_shard(std::string_view text);

/// The number of the shard of each submission, 1 to `count`. Equal sources share a shard, and sources with the same
/// include block lie together, so that few machines make its header. Shards are as equal in size as that allows; one
/// may be empty. Neither names nor the order of the submissions matter.
std::vector<int> split(const std::vector<Submission>& submissions, int count);

}  // namespace harness
