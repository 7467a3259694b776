#include "reference/kernel/first.h"

#include "reference/kernel/integers.h"
#include "reference/kernel/order.h"

namespace reference::kernel {
namespace {

/// An object that is hit, with the t that the kernel computed for it.
struct Candidate {
    Subject kind;
    std::size_t index;
    double t;
};

/// Both t's are within one unit in the last place, so a difference above 8u of the larger t decides, if nothing is
/// subnormal.
std::partial_ordering filtered_order(double one, double other) {
    const double slack = 0x1p-50 * std::max(one, other);
    if (!(slack > 0x1p-1000) || !std::isfinite(slack)) return std::partial_ordering::unordered;
    if (one - other < -slack) return std::partial_ordering::less;
    if (one - other > slack) return std::partial_ordering::greater;
    return std::partial_ordering::unordered;
}

// The t's of objects that are hit.
auto exact_t(const auto& whole, const Ray<double>& ray, const Sphere<double>& sphere) {
    const auto quadratic = quadratic_of(whole, ray, sphere);
    return Root{quadratic, quadratic.smaller_is_first()};
}
auto exact_t(const auto& whole, const Ray<double>& ray, const Triangle<double>& triangle) {
    const auto determinants = determinants_of(whole, ray, triangle);
    return Fraction{determinants.t(), determinants.det()};
}
ExactT<Integer> exact_t(const Whole<Integer>& whole, const Ray<double>& ray, const Cylinder<double>& cylinder) {
    const CylinderForm<Integer> form = cylinder_form_of(whole, ray, cylinder);
    return kernel::exact_t(form, choose_crossing(form, Boundary::nonnegative).crossing.at);
}

template <class One, class Other>
constexpr bool are_spheres = std::is_same_v<One, Sphere<double>>&& std::is_same_v<Other, Sphere<double>>;
/// Whether numbers of any size hold the object's t, and not Integers alone.
template <class Object>
constexpr bool has_short_t = requires(const Whole<Fixed<28>>& whole, const Ray<double>& ray, const Object& object) {
    exact_t(whole, ray, object);
};

/// The order of two objects that are hit.
template <class One, class Other>
std::partial_ordering exact_order(const Ray<double>& ray, const One& one, const Other& other) {
    const Scales scales(ray, one, other);
    if constexpr (!has_short_t<One> || !has_short_t<Other>) {
        const Whole<Integer> whole(scales);
        return order(ExactT<Integer>(exact_t(whole, ray, one)), ExactT<Integer>(exact_t(whole, ray, other)));
    } else {
        return in_whole_numbers(scales, [&](const auto& whole) {
            const auto one_t = exact_t(whole, ray, one);
            const auto other_t = exact_t(whole, ray, other);
            if constexpr (are_spheres<One, Other>) {
                return order_with_same_a(one_t, other_t);
            } else {
                return order(one_t, other_t);
            }
        });
    }
}

template <class Use>
std::partial_ordering with_object(const Objects& objects, const Candidate& candidate, Use use) {
    auto result = std::partial_ordering::unordered;
    for_each_kind(
        [&](Subject kind, const auto& of_kind) {
            if (kind == candidate.kind) result = use(of_kind[candidate.index]);
        },
        objects);
    return result;
}

/// The order of a's t and b's t.
std::partial_ordering order_of(const Ray<double>& ray, const Objects& objects, const Candidate& a, const Candidate& b) {
    const auto filtered = filtered_order(a.t, b.t);
    if (filtered != std::partial_ordering::unordered) return filtered;
    return with_object(objects, a, [&](const auto& one) {
        return with_object(objects, b, [&](const auto& other) { return exact_order(ray, one, other); });
    });
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

std::partial_ordering order_exactly(const Ray<double>& ray, const Sphere<double>& sphere,
                                    const Triangle<double>& triangle) {
    return exact_order(ray, sphere, triangle);
}

std::partial_ordering order_exactly(const Ray<float>& ray, const Sphere<float>& sphere,
                                    const Triangle<float>& triangle) {
    return exact_order(as_double(ray), as_double(sphere), as_double(triangle));
}

std::partial_ordering order_exactly(const Ray<double>& ray, const Object& one, const Object& other) {
    return std::visit([&](const auto& a, const auto& b) { return exact_order(ray, a, b); }, one, other);
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
