// The scripts by which Slurm grades a class in shards on several machines.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
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
    std::vector<std::string> classes;  ///< the paths of the class
    std::vector<std::string> options;  ///< more words for `raygrade grade`
    std::vector<std::string> merge_options;
    std::string fingerprint;  ///< of all that the parts are made from
    int shards = 1;
};

/// What Slurm is asked for.
struct SlurmLimits {
    std::string partition;            ///< empty for Slurm's default
    int minutes = 60;                 ///< of a shard; 0 for what the work takes at most
    std::uint64_t memory_mib = 4096;  ///< likewise
    int cpus = 1;
};

/// What is done for each submission, and the limits of its parts.
struct Work {
    std::size_t submissions = 0;  ///< of all shards together
    int shards = 1;
    int scenes = 1;  ///< a submission is compiled once for each
    int runs = 1;    ///< of each scene
    std::chrono::milliseconds compile{}, run{};
    std::uint64_t memory_bytes = 0;         ///< the most that compiler or program may take
    std::chrono::milliseconds sanitized{};  ///< to compile and run it under the sanitizers too; 0 if it is not
};

struct Script {
    std::string name;  ///< "submit"
    std::string text;
};

/// One word for a shell, whatever is in it. Throws UsageError for a line break, which no script could show readably.
std::string quoted(const std::string& word);

/// In place of a 0, what a shard takes if every submission of it goes to its limits.
SlurmLimits limits_for(const Work& work, SlurmLimits asked);

std::vector<Script> slurm_scripts(const Plan& plan, const SlurmLimits& limits);

/// Writes the scripts, and removes parts that `again` gives up. Throws UsageError if the folder holds something else,
/// or parts that were made from something else and are not given up.
enum class OldParts { keep, give_up };
void write_scripts(const Plan& plan, const std::vector<Script>& scripts, OldParts old_parts);

}  // namespace harness::cluster
