// The scripts for grading a class in shards on several machines with Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace harness::cluster {

/// The class and its options. All paths must be valid on all machines.
struct Plan {
    std::filesystem::path work;      ///< base of relative paths; absolute
    std::filesystem::path raygrade;  ///< the program; absolute
    std::filesystem::path folder;    ///< of scripts, parts and logs; absolute
    std::filesystem::path results;
    std::vector<std::string> classes{};  ///< the paths of the class
    std::vector<std::string> options{};  ///< more words for `raygrade grade`
    int shards = 1;
};

/// Quotes any text as one shell word. Throws UsageError for a line break, because a script can't show it readably.
std::string quoted(const std::string& word);

/// Writes the scripts submit, shard, merge and status to the plan's folder. Throws UsageError if the folder has files
/// in it, because parts of an earlier class would be merged into this one.
void write_scripts(const Plan& plan);

}  // namespace harness::cluster
