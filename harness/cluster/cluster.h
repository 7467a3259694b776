// The scripts by which Slurm grades a class in shards on several machines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace harness::cluster {

/// What to grade. All paths are seen alike by all machines.
struct Plan {
    std::filesystem::path work;      ///< where relative paths start; absolute
    std::filesystem::path raygrade;  ///< the program; absolute
    std::filesystem::path folder;    ///< of scripts, parts and logs; absolute
    std::filesystem::path results;
    std::vector<std::string> classes{};  ///< the paths of the class
    std::vector<std::string> options{};  ///< more words for `raygrade grade`
    int shards = 1;
};

/// One word for a shell, whatever is in it. Throws UsageError for a line break, which no script could show readably.
std::string quoted(const std::string& word);

/// Writes the scripts submit, shard, merge and status to the plan's folder. Throws UsageError for a folder with files
/// in it: parts of an earlier class would be merged into this one.
void write_scripts(const Plan& plan);

}  // namespace harness::cluster
