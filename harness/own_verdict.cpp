#include "harness/own_verdict.h"

#include <cmath>
#include <optional>

#include "harness/closeness.h"
#include "reference/stages/sphere.h"

namespace harness {
namespace {

using reference::Boundary;

/// A printed t as a hit: empty for none, for a t before the start, and for one that rounds to 0 where 0 is no hit.
std::optional<double> hit_at(const MatchedItem& printed, Boundary boundary, int min_decimals) {
    if (printed.value->numbers.empty()) return std::nullopt;
    const PrintedNumber& t = printed.value->numbers.front();
    const bool zero = std::abs(t.value) <= half_unit(t, min_decimals);
    if (zero) return boundary == Boundary::nonnegative ? std::optional(0.0) : std::nullopt;
    return t.value > 0 ? std::optional(t.value) : std::nullopt;
}

/// Whether u and v lie in the triangle, edges included, as far as their digits tell.
bool inside(const MatchedItem& u, const MatchedItem& v, int min_decimals) {
    if (u.value->numbers.empty() || v.value->numbers.empty()) return false;
    const PrintedNumber& bu = u.value->numbers.front();
    const PrintedNumber& bv = v.value->numbers.front();
    const double slack = half_unit(bu, min_decimals) + half_unit(bv, min_decimals);
    return bu.value >= -slack && bv.value >= -slack && bu.value + bv.value <= 1 + slack;
}

}  // namespace

std::vector<reference::Verdict> own_verdicts(const OwnHits& hits, int min_decimals) {
    std::vector<reference::Verdict> verdicts;
    if (hits.sphere_t == nullptr || hits.triangle_t == nullptr) return verdicts;
    const bool in_triangle = hits.u == nullptr || hits.v == nullptr || inside(*hits.u, *hits.v, min_decimals);
    for (const Boundary boundary : {Boundary::nonnegative, Boundary::positive}) {
        const auto sphere = hit_at(*hits.sphere_t, boundary, min_decimals);
        const auto triangle = in_triangle ? hit_at(*hits.triangle_t, boundary, min_decimals) : std::nullopt;
        if (const auto verdict = reference::first_hit(sphere, triangle)) verdicts.push_back(*verdict);
    }
    return verdicts;
}

}  // namespace harness
