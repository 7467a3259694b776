#include "harness/mark/compare/first_hit.h"

#include <algorithm>

namespace harness {
namespace {

using reference::Boundary;
using reference::Verdict;
using enum Hits;

/// Whether x >= 0, if a student may tolerate values down to -`allowance`.
Hits not_negative(const Interval& x, double allowance) {
    if (x.lo() >= 0) return yes;
    return x.hi() + allowance < 0 ? no : maybe;
}

Hits is_in_front(const Interval& t, double allowance, Boundary boundary) {
    if (boundary == Boundary::nonnegative) return not_negative(t, allowance);
    if (t.lo() > allowance) return yes;  // a student may require t > 1e-6 to avoid a hit at the ray's start
    return t.hi() + allowance < 0 || t.is_zero() ? no : maybe;
}

Hits worst(std::initializer_list<Hits> answers) {
    return std::max(answers);
}

/// Which object is first if both are hit. All orders are possible if the digits leave it open.
std::vector<Verdict> order_of(const Interval& sphere_t, const Interval& triangle_t) {
    if (sphere_t.hi() < triangle_t.lo()) return {Verdict::sphere_first};
    if (triangle_t.hi() < sphere_t.lo()) return {Verdict::triangle_first};
    return {Verdict::tie, Verdict::sphere_first, Verdict::triangle_first};
}

void add(std::vector<Verdict>& verdicts, const std::vector<Verdict>& more) {
    for (const Verdict verdict : more) {
        if (std::find(verdicts.begin(), verdicts.end(), verdict) == verdicts.end()) verdicts.push_back(verdict);
    }
}

}  // namespace

Hits hits_triangle(const HitValues& values, Boundary boundary) {
    if (!values.triangle_t) return no;
    const Hits in_front = is_in_front(*values.triangle_t, values.t_allowance, boundary);
    if (!values.u || !values.v) return in_front;
    const Interval rest = Interval(1) - *values.u - *values.v;
    return worst({in_front, not_negative(*values.u, values.uv_allowance), not_negative(*values.v, values.uv_allowance),
                  not_negative(rest, 2 * values.uv_allowance)});
}

std::vector<Verdict> possible_verdicts(const HitValues& values, std::span<const Boundary> boundaries) {
    std::vector<Verdict> verdicts;
    for (const Boundary boundary : boundaries) {
        const Hits sphere = values.sphere_t ? is_in_front(*values.sphere_t, values.t_allowance, boundary) : no;
        const Hits triangle = hits_triangle(values, boundary);
        if (sphere != no && triangle != no) add(verdicts, order_of(*values.sphere_t, *values.triangle_t));
        if (sphere != no && triangle != yes) add(verdicts, {Verdict::sphere_first});
        if (sphere != yes && triangle != no) add(verdicts, {Verdict::triangle_first});
        if (sphere != yes && triangle != yes) add(verdicts, {Verdict::no_hit});
    }
    return verdicts;
}

std::optional<Verdict> smaller_t(const HitValues& values) {
    if (!values.sphere_t || !values.triangle_t) return std::nullopt;
    const std::vector<Verdict> order = order_of(*values.sphere_t, *values.triangle_t);
    return order.size() == 1 ? std::optional(order.front()) : std::nullopt;
}

}  // namespace harness
