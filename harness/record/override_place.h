// The place of an override, in the form that people write: "6.t", "6", "variants" or "total".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "harness/record/graded.h"

namespace harness {

struct OverridePlace {
    int question = 0;  ///< 0 for the whole submission, or for variants_place
    std::string item;  ///< empty for the whole question
};

/// "6.t", "6", "variants" or "total".
std::string to_string(const OverridePlace& place);
std::string place_of(const Override& given);

/// "question 6, t", "question 6", "the other scenes" or "the whole submission", for a place as place_of gives it.
std::string place_in_words(std::string_view place);

/// The automatic points and the maximum at the place of an override. points_at is empty if the score has no such place.
struct PlacePoints {
    double automatic = 0;
    double most = 0;
};
std::optional<PlacePoints> points_at(const Score& score, const Override& given);

/// An override and its submission, which may no longer be in the class.
struct KeptOverride {
    std::string submission;
    Override given;
};
bool is_same_place(const KeptOverride& kept_override, const KeptOverride& other);

/// Gives each submission its overrides. Returns the overrides whose submission or item does not exist.
std::vector<KeptOverride> attach(const std::vector<KeptOverride>& overrides, std::vector<Graded>& graded);

/// Reads a place of a submission's score. Throws UsageError, with similar names, if there is no such place. A
/// submission that was not graded has no place but the total; any other place throws UsageError.
OverridePlace read_place(std::string_view text, const Graded& graded);

/// The same for a single item. Throws UsageError for a question or the total, with an item of it.
OverridePlace read_item_place(std::string_view text, const Graded& graded);

/// Reads points such as "1.5", from 0 to a million, for this place. If the number equals the maximum or the automatic
/// points as printed in reports, returns those exactly: 1.67 means five thirds. Throws UsageError.
double read_override_points(std::string_view text, const PlacePoints& there);

/// Reads a reason or a name as a single line, without control characters and surrounding blanks. Throws UsageError,
/// whose message begins with `option`, if nothing is left or the text is longer than 2,000 bytes.
std::string read_line(std::string_view text, std::string_view option);

}  // namespace harness
