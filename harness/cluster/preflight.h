// Whether a machine is like the others of a cluster, asked before it grades.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "harness/shards/conditions.h"

namespace harness::cluster {

struct Node {
    std::string name;  ///< of the machine
    std::vector<Condition> conditions;
};

/// The first machine that comes writes `file`, of several at a time exactly one. Any other gets the conditions in which
/// it differs, as a message; empty if in none. Throws HarnessError if the file can't be written or is damaged.
std::string difference_from_first(const Node& node, const std::filesystem::path& file);

}  // namespace harness::cluster
