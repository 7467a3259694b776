// What must be the same on all machines that grade a class.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "harness/run/runner.h"

namespace harness {

/// Something that must be the same on all machines, or their results are not of one grading.
struct Condition {
    std::string what;   ///< a noun: "compiler"
    std::string value;  ///< a fingerprint, or a few words

    bool operator==(const Condition&) const = default;
};

/// What a machine brings along, whichever class it grades. The first says which raygrade it is.
std::vector<Condition> machine_conditions(const Runner& runner);

/// A condition that two lists have differently.
struct Difference {
    std::string what;
    std::string here, there;  ///< empty where a list lacks it
};

/// In the order of `here`, and then those that only `there` has.
std::vector<Difference> differences(const std::vector<Condition>& here, const std::vector<Condition>& there);

/// An object with a text for each condition.
nlohmann::ordered_json to_json(const std::vector<Condition>& conditions);

/// Throws nlohmann's exception if `json` is anything but such an object.
std::vector<Condition> conditions_in(const nlohmann::ordered_json& json);

}  // namespace harness
