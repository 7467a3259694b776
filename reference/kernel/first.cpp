#include "reference/kernel/first.h"

namespace reference::kernel {
namespace {

/// An object that is hit, and the t that the kernel computed for it.
struct Candidate {
    Subject kind;
    std::size_t index;
    double t;
};

Object object_of(const Objects& objects, const Candidate& candidate) {
    Object object;
    for_each_kind(
        [&](Subject kind, const auto& of_kind) {
            if (kind == candidate.kind) object = of_kind[candidate.index];
        },
        objects);
    return object;
}

/// The order of a's t and b's t. Both doubles are within one unit in the last place, so a difference above 8u of the
/// larger decides, if nothing is subnormal.
std::partial_ordering order_of(const Ray<double>& ray, const Objects& objects, const Candidate& a, const Candidate& b) {
    const double slack = 0x1p-50 * std::max(a.t, b.t) + 0x1p-1000;
    if (std::isfinite(slack) && std::abs(a.t - b.t) > slack) return a.t <=> b.t;
    return order_exactly(ray, object_of(objects, a), object_of(objects, b));
}

template <class Visit>
void for_each_hit(const Cast& cast, Visit visit) {
    for_each_kind(
        [&](Subject kind, const auto& hits) {
            for (std::size_t i = 0; i < hits.size(); ++i) {
                if (is_hit(hits[i].result)) visit({kind, i, hits[i].t});
            }
        },
        cast);
}

bool holds_invalid(const Cast& cast) {
    bool holds = false;
    for_each_kind(
        [&](Subject /*kind*/, const auto& hits) {
            for (const auto& hit : hits) holds = holds || hit.result == decltype(hit.result)::invalid;
        },
        cast);
    return holds;
}

}  // namespace

std::partial_ordering order_exactly(const Ray<double>& ray, const Object& object, const Object& other) {
    const auto t_of = [&](const Object& asked) {
        return std::visit([&](const auto& of_kind) { return exact_t(ray, of_kind); }, asked);
    };
    return reference::order_of(t_of(object), t_of(other));
}

void cast_ray(const Ray<double>& ray, const Objects& objects, Cast& result) {
    for_each_kind(
        [&](Subject /*kind*/, const auto& of_kind, auto& hits) {
            hits.clear();
            for (const auto& object : of_kind) hits.push_back(intersect(ray, object));
        },
        objects, result);
    result.first = {};
    if (!is_valid(ray) || holds_invalid(result)) return;
    std::optional<Candidate> best;
    bool tie = false;
    for_each_hit(result, [&](const Candidate& candidate) {
        const auto compared = best ? order_of(ray, objects, *best, candidate) : std::partial_ordering::greater;
        if (compared < 0) return;
        tie = compared == 0;
        if (!tie) best = candidate;
    });
    result.first.object = tie ? FirstObject::tie : best ? FirstObject(best->kind) : FirstObject::no_hit;
    if (!tie && best) result.first.index = best->index;
}

}  // namespace reference::kernel
