// How each arithmetic answers a hard case: the stages in float and in double, and the certified kernel.
#pragma once

#include <array>
#include <string>

#include "reference/hard_cases/cases.h"

namespace reference::hard_cases {

enum class Arithmetic { float_, double_, certified };
inline constexpr std::array arithmetics{Arithmetic::float_, Arithmetic::double_, Arithmetic::certified};
/// "float", "double", "certified".
std::string_view to_string(Arithmetic arithmetic);

struct Answer {
    std::string_view decision;    ///< as in Case; "nan" where a sign is not a number
    std::vector<double> numbers;  ///< as in Case; empty without a hit
};
Answer answer(const Case& hard, Arithmetic arithmetic);

/// Whether the answer agrees with the case about hit or miss, names the same object as first, and has 5 right digits in
/// every number: float has 6, and rounding may cost one in any scene.
bool is_right(const Case& hard, const Answer& answer);

/// The number that the case quotes, and one unit of its last digit.
struct Quoted {
    double value;
    double unit;
};
Quoted quoted(std::string_view number);

}  // namespace reference::hard_cases
