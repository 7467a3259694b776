// Which marks an override replaces, as people write it: "6.t", "6", "variants" or "total".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/grade.h"

namespace harness {

struct OverridePlace {
    int question = 0;  ///< 0 for the whole submission, or for other_scenes_place
    std::string item;  ///< empty for the whole question
};

/// "6.t", "6", "variants" or "total".
std::string to_string(const OverridePlace& place);
std::string place_of(const Override& given);

/// "question 6, t", "question 6", "the other scenes" or "the whole", for a sentence.
std::string place_in_words(const Override& given);

/// The points there, as they were given automatically and at the most. Empty when the score has no such place.
struct PlacePoints {
    double automatic = 0;
    double most = 0;
};
std::optional<PlacePoints> points_at(const Score& score, const Override& given);

/// An override with the submission it is for, which need not be in the class any more.
struct KeptOverride {
    std::string submission;
    Override given;
};
bool is_same_place(const KeptOverride& one, const KeptOverride& other);

/// Gives each submission its overrides. The result are those for which there is no submission or no such item.
std::vector<KeptOverride> attach(const std::vector<KeptOverride>& overrides, std::vector<Graded>& graded);

/// Reads a place of a submission's score. Throws UsageError with the near names when there is none, and for a part of
/// what was not graded: of that only the total can be given.
OverridePlace read_place(std::string_view text, const Graded& graded);

/// "1.5": at least 0, at most a million. Throws UsageError.
double read_override_points(std::string_view text);

/// A reason or a name as one line without control characters and blanks around it. Throws UsageError, which begins with
/// `option`, when nothing is left of it or it is longer than 2,000 bytes.
std::string read_line(std::string_view text, std::string_view option);

}  // namespace harness
