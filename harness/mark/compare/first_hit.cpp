#include "harness/mark/compare/first_hit.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace harness {
namespace {

using reference::Boundary;
using reference::FirstObject;
using reference::Subject;
using enum Hits;

/// Whether x >= 0, if a student may accept values down to -`allowance`.
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

using Times = std::map<Subject, Interval>;

/// The first of these objects, which are all hit. Several if the digits do not decide.
std::vector<FirstObject> order_of(const Times& times) {
    if (times.empty()) return {FirstObject::no_hit};
    double earliest_end = HUGE_VAL;
    for (const auto& [object, t] : times) earliest_end = std::min(earliest_end, t.hi());
    std::vector<FirstObject> objects;
    for (const auto& [object, t] : times) {
        if (t.lo() <= earliest_end) objects.emplace_back(object);
    }
    if (objects.size() > 1) objects.push_back(FirstObject::tie);
    return objects;
}

void add(std::vector<FirstObject>& objects, const std::vector<FirstObject>& more) {
    for (const FirstObject object : more) {
        if (std::find(objects.begin(), objects.end(), object) == objects.end()) objects.push_back(object);
    }
}

}  // namespace

Hits hits_triangle(const HitValues& values, Boundary boundary) {
    const auto t = values.t.find(Subject::triangle);
    if (t == values.t.end() || !t->second) return no;
    const Hits in_front = is_in_front(*t->second, values.t_allowance, boundary);
    if (!values.u || !values.v) return in_front;
    const Interval rest = Interval(1) - *values.u - *values.v;
    return worst({in_front, not_negative(*values.u, values.uv_allowance), not_negative(*values.v, values.uv_allowance),
                  not_negative(rest, 2 * values.uv_allowance)});
}

std::vector<FirstObject> possible_first_objects(const HitValues& values, std::span<const Boundary> boundaries) {
    std::vector<FirstObject> objects;
    for (const Boundary boundary : boundaries) {
        std::vector<Times> possible(1);  // the sets of objects that may be hit
        for (const auto& [object, t] : values.t) {
            Hits hits = no;
            if (object == Subject::triangle) {
                hits = hits_triangle(values, boundary);
            } else if (t) {
                hits = is_in_front(*t, values.t_allowance, boundary);
            }
            if (hits == no) continue;
            std::vector<Times> with = possible;
            for (Times& times : with) times.emplace(object, *t);
            if (hits == yes) possible.clear();
            possible.insert(possible.end(), with.begin(), with.end());
        }
        for (const Times& times : possible) add(objects, order_of(times));
    }
    return objects;
}

std::optional<FirstObject> smaller_t(const HitValues& values) {
    Times times;
    for (const auto& [object, t] : values.t) {
        if (!t) return std::nullopt;
        times.emplace(object, *t);
    }
    if (times.size() < 2) return std::nullopt;
    const std::vector<FirstObject> order = order_of(times);
    return order.size() == 1 ? std::optional(order.front()) : std::nullopt;
}

}  // namespace harness
