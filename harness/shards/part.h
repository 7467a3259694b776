// A part: the graded submissions of one shard in a file, with everything that merging them with the others takes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "harness/execution/tier.h"
#include "harness/gradebook/run.h"
#include "harness/record/graded.h"
#include "harness/shards/shard.h"
#include "reference/toml/assignment.h"

namespace harness {

/// Thrown for a file that is no whole part; what() is a clause: "is cut off".
class DamagedFile : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The first line of the file.
struct PartHead {
    Shard shard{};
    std::size_t class_size = 0;   ///< submissions of the whole class
    std::size_t submissions = 0;  ///< of this part
    /// What must be the same in all parts, or their results are not of one grading: an object of a text for each noun,
    /// such as "compiler". The first is "raygrade" with its version.
    nlohmann::ordered_json alike = nlohmann::ordered_json::object();
};

/// A submission, without its overrides and the name that a roster gives it, and its index in the class as taken in.
struct IndexedGraded {
    std::size_t index = 0;
    Graded graded;
};

struct Part {
    PartHead head{};
    reference::AssignmentFile file{};
    Tier tier = Tier::bwrap;
    std::vector<KeptInput> inputs{};  ///< the lists of students that it was given
    std::vector<IndexedGraded> graded{};
};

/// Stands in the first line of every part.
inline constexpr const char* part_schema = "raygrade/part/1";

/// Writes the file atomically: the head as a line, a line with the size and the seal of the rest, and the rest as CBOR.
/// The seal guards against accidents of disks and networks, not against a person who writes such a file. Throws
/// HarnessError.
void write_part(const Part& part, const std::filesystem::path& file);

/// Throw DamagedFile, also for a file that is no part.
PartHead read_part_head(const std::filesystem::path& file);
Part read_part(const std::filesystem::path& file);

}  // namespace harness
