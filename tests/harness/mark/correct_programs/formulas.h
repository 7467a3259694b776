// The formulas that correct programs use for the handout's stages: what textbooks and tutorials teach and students
// copy.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace correct {

/// One stage of a program, and the formulas there are for it, by number. Sources: the handout; GLM; Shirley and
/// Marschner, "Fundamentals of Computer Graphics"; Möller and Trumbore (1997); Ericson, "Real-Time Collision
/// Detection"; Haines et al., "Precision Improvements for Ray/Sphere Intersection" (Ray Tracing Gems, 2019); Shirley,
/// "Ray Tracing in One Weekend"; scratchapixel.com.
struct Stage {
    std::string_view name;
    std::array<std::string_view, 9> formulas;  ///< empty names at the end

    constexpr int count() const {
        int n = 0;
        while (n < 9 && !formulas[static_cast<std::size_t>(n)].empty()) ++n;
        return n;
    }
};

inline constexpr std::array<Stage, 11> stages = {{
    {"pixel",
     {"l + (r - l)(x + 1/2)/W", "l + (x + 1/2) dx", "l + dx/2 + x dx", "l (1 - s) + r s with s = (x + 1/2)/W",
      "from -1..1: n (r - l)/2 + (r + l)/2"}},
    {"axes",
     {"Z, X = vup x Z, Y = Z x X", "each axis normalized", "glm::lookAt's rows", "vup normalized first",
      "forward, right and up", "normalized last", "vup less its part along Z", "divided by their lengths"}},
    {"matrix",
     {"axes and eye as columns", "glm::inverse of axes as rows", "glm::inverse(glm::lookAt)",
      "translation times rotation", "transposed rotation, and what it makes of the moved eye",
      "glm::inverse of rotation times translation"}},
    {"point", {"M * vec4", "eye + x X + y Y - n Z", "row by row", "divided by w"}},
    {"direction", {"normalize(S - eye)", "x X + y Y - n Z", "M * vec4(normalize(p), 0)", "divided by the length"}},
    {"coefficients",
     {"dot products with S - C", "component by component", "c = S.S - 2 S.C + C.C - R^2", "c = length(S - C)^2 - R^2",
      "c = (length(S - C) - R)(length(S - C) + R)", "a = 1"}},
    {"root",
     {"(-b -+ sqrt d)/(2a)", "half of b", "without cancellation", "tca and thc", "-b/(2a) -+ sqrt(d)/(2a)",
      "the nearest point first", "(-b -+ sqrt d)/2"}},
    {"sphere normal", {"normalize(P - C)", "(P - C)/R", "(P - C)/length(P - C)"}},
    {"solution",
     {"Cramer by dot and cross products", "glm::inverse", "Cramer by glm::determinant", "Moller and Trumbore",
      "Gauss with pivots where needed", "Gauss with pivots", "Gauss-Jordan", "plane, then barycentric by dot products",
      "plane, then areas"}},
    {"triangle hit", {"S + tV", "A + u(B - A) + v(C - A)", "(1 - u - v)A + uB + vC"}},
    {"triangle normal",
     {"normalize((B - A) x (C - A))", "of normalized edges", "-(C - A) x (B - A)", "(B - A) x (C - B)"}},
}};

/// A program's choice for each stage, in their order.
using Formulas = std::array<int, stages.size()>;

/// What a program computes in. `mixed`: float variables and double constants, "2.0 * b".
inline constexpr std::array<std::string_view, 4> scalars = {"float", "mixed", "double", "long double"};

/// How a program prints: glm::to_string and its six decimals; six digits of a stream; nine digits.
inline constexpr std::array<std::string_view, 3> printings = {"to_string", "stream", "nine digits"};

}  // namespace correct
