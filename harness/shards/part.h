// A part: a file with the graded submissions of one shard and all data needed for merging.
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

/// Thrown for a file that is not a complete part; what() is a clause: "is cut off".
class DamagedFile : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The first line of the file.
struct PartHead {
    Shard shard{};
    std::size_t class_size = 0;   ///< number of submissions in the whole class
    std::size_t submissions = 0;  ///< of this part
    /// The conditions that must be equal in all parts: an object with a text for each noun, such as "compiler". The
    /// first is "raygrade" with its version.
    nlohmann::ordered_json alike = nlohmann::ordered_json::object();
};

/// A submission, without its overrides and its name from a roster, and its index in the class at intake.
struct IndexedGraded {
    std::size_t index = 0;
    Graded graded;
};

struct Part {
    PartHead head{};
    reference::AssignmentFile file{};
    Tier tier = Tier::bwrap;
    std::vector<KeptInput> inputs{};  ///< the lists of students given to this grading
    std::vector<IndexedGraded> graded{};
};

/// Appears in the first line of every part.
inline constexpr const char* part_schema = "raygrade/part/1";

/// Writes the file atomically: a line with the head, a line with the size and the checksum ("seal") of the rest, and
/// the rest as CBOR. The seal protects against disk and network errors, not against deliberate changes. Throws
/// HarnessError.
void write_part(const Part& part, const std::filesystem::path& file);

/// Both throw DamagedFile, also for a file that is not a part.
PartHead read_part_head(const std::filesystem::path& file);
Part read_part(const std::filesystem::path& file);

}  // namespace harness
