// The measured cost of accuracy.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace reference::accuracy {

enum class Primitive { sphere, triangle, cylinder, cast };

/// How far the t of right hits is from the truth, in units in the last place of float at the true t.
struct TError {
    double max_ulp = 0;
    double mean_ulp = 0;
};

struct Quartiles {
    double low = 0;
    double median = 0;
    double high = 0;
};

/// One method on one distribution of rays.
struct Row {
    Primitive primitive;
    std::string kernel;        ///< "half-b", unique together with `scalar` within a primitive
    std::string scalar;        ///< "float" or "double"
    std::string source;        ///< where the method is from: a paper, a book, a library
    std::string distribution;  ///< "grazing"
    bool hard = false;         ///< the distribution aims at what rounding gets wrong
    std::uint64_t rays = 0;    ///< how many were judged
    double ns_per_ray = 0;    ///< median of the repetitions; CPU time of the thread, without the time of other programs
    double ns_low = 0;        ///< lower quartile
    double ns_high = 0;       ///< upper quartile
    std::uint64_t wrong = 0;  ///< hit for miss, miss for hit, or a wrong order
    double wrong_per_million = 0;
    double wrong_low = 0;  ///< 95 % Wilson interval of wrong_per_million
    double wrong_high = 0;
    std::optional<TError> t_error{};  ///< empty without a right hit
    /// Pareto-optimal: no method is better in time or wrongness and at least as good in the other.
    bool pareto = false;
    bool certain = false;  ///< the method's decisions are proven to be right
};

struct Measurement {
    std::uint64_t seed = 0;
    std::uint64_t rays = 0;  ///< of each distribution
    int repetitions = 0;
    std::string compiler;   ///< with its version
    std::string flags;      ///< the compiler flags that arithmetic depends on
    std::string processor;  ///< as the operating system names it; empty if it does not
    /// How many other programs wanted a processor when the measurement began.
    double load = 0;
    std::array<Quartiles, 3> key_ms{};  ///< for one answer key, in float, in double and certified
    std::vector<Row> rows;              ///< by primitive, distribution and the ladder's order of methods
};

inline std::string name_of(Primitive primitive) {
    return std::array{"sphere", "triangle", "cylinder", "cast"}.at(static_cast<std::size_t>(primitive));
}

}  // namespace reference::accuracy
