// The cylinder's mistakes, in the handout's steps of 2024: the tube's quadratic, the caps, and the hit with the
// smallest t of them.
#include <algorithm>
#include <cmath>

#include "tests/given/student/mistake_parts.h"

namespace student {
namespace {

using glm::dot;
using glm::normalize;
using glm::vec3;

namespace tube = reference::item::cylinder;

/// A cylinder of the endless tube around `axis` and two caps. A mistake changes some of its numbers, or leaves out a
/// step.
struct Steps {
    explicit Steps(const Names& n)
        : S(n.S()),
          V(n.direction()),
          axis(n.cylinder().center),
          cap_axis(axis),
          tube_square(n.cylinder().radius * n.cylinder().radius),
          cap_square(tube_square),
          top(axis.y + n.cylinder().height / 2),
          bottom(axis.y - n.cylinder().height / 2) {}

    float along_axis(const vec3& p, const vec3& q) const { return p.x * q.x + p.z * q.z + (y_too ? p.y * q.y : 0); }

    /// Every hit, sorted.
    std::vector<float> hits() const {
        std::vector<float> all;
        const float p = along_axis(V, V), q = 2 * along_axis(S - axis, V),
                    r = along_axis(S - axis, S - axis) - tube_square, d = q * q - 4 * p * r;
        for (const float sign : {-1.0F, 1.0F}) {
            const float t = (-q + sign * std::sqrt(d)) / (2 * p), y = S.y + t * V.y;
            if (has_tube && d >= 0 && (!is_tube_bounded || (bottom <= y && y <= top))) all.push_back(t);
        }
        for (const float y : {top, bottom}) {
            const float t = (y - S.y) / V.y;
            const float x = S.x + t * V.x - cap_axis.x, z = S.z + t * V.z - cap_axis.z;
            if (has_caps && (!are_caps_bounded || x * x + z * z < cap_square)) all.push_back(t);
        }
        std::sort(all.begin(), all.end());
        return all;
    }

    vec3 S, V, axis, cap_axis;
    float tube_square, cap_square;
    float top, bottom;
    bool has_tube = true, has_caps = true, is_tube_bounded = true, are_caps_bounded = true;
    bool y_too = false;  ///< in the tube's equation
};

using Result = std::optional<Floats>;

Result smallest_positive(const std::vector<float>& hits) {
    const auto found = std::find_if(hits.begin(), hits.end(), [](float t) { return t > 0; });
    return found == hits.end() ? Result() : floats(*found);
}

/// The t of the steps that `change` has changed.
template <class Change>
NamedMistake in_steps(std::string_view name, Change change) {
    return {name, {tube::t, [change](const Program& p, const auto&) {
                       Steps steps{Names(p)};
                       change(steps, Names(p));
                       return smallest_positive(steps.hits());
                   }}};
}

/// choose(all hits, sorted), which are at least one.
template <class Choose>
NamedMistake in_choice(std::string_view name, Choose choose) {
    return {name, {tube::t, [choose](const Program& p, const auto& right) {
                       const std::vector<float> hits = Steps(Names(p)).hits();
                       return hits.empty() ? right : Result(floats(choose(hits)));
                   }}};
}

std::vector<NamedMistake> of_tube_coefficients() {
    const auto from_center = [](const Names& n) { return n.S() - n.cylinder().center; };
    const auto R = [](const Names& n) { return n.cylinder().radius; };
    const auto level = [](const vec3& p, const vec3& q) { return p.x * q.x + p.z * q.z; };
    const auto disc = [](float p, float q, float r, float factor) { return q * q - factor * p * r; };
    return {
        on("y in the tube's equation", tube::a, [](const Names& n) { return dot(n.direction(), n.direction()); }),
        on("y in the tube's equation", tube::b, [=](const Names& n) { return 2 * dot(n.direction(), from_center(n)); }),
        on("factor 2 missing", tube::b, [=](const Names& n) { return level(n.direction(), from_center(n)); }),
        on("center forgotten", tube::b, [=](const Names& n) { return 2 * level(n.direction(), n.S()); }),
        on("y in the tube's equation", tube::c,
           [=](const Names& n) { return dot(from_center(n), from_center(n)) - R(n) * R(n); }),
        on("radius not squared", tube::c, [=](const Names& n) { return level(from_center(n), from_center(n)) - R(n); }),
        on("center forgotten", tube::c, [=](const Names& n) { return level(n.S(), n.S()) - R(n) * R(n); }),
        on("factor 4 missing", tube::d,
           [=](const Names& n) { return disc(n.at(tube::a), n.at(tube::b), n.at(tube::c), 1); }),
        on("discriminant negated", tube::d,
           [=](const Names& n) { return -disc(n.at(tube::a), n.at(tube::b), n.at(tube::c), 4); }),
    };
}

std::vector<NamedMistake> of_parts() {
    return {
        in_steps("no height bound", [](Steps& s, const Names&) { s.is_tube_bounded = false; }),
        in_steps("no height bound", [](Steps& s, const Names&) { s.is_tube_bounded = s.has_caps = false; }),
        in_steps("only tube", [](Steps& s, const Names&) { s.has_caps = false; }),
        in_steps("only caps", [](Steps& s, const Names&) { s.has_tube = false; }),
        in_steps("no radius bound", [](Steps& s, const Names&) { s.are_caps_bounded = false; }),
        in_steps("height not halved",
                 [](Steps& s, const Names& n) {
                     s.top = s.axis.y + n.cylinder().height;
                     s.bottom = s.axis.y - n.cylinder().height;
                 }),
        in_steps("center at a cap",
                 [](Steps& s, const Names& n) {
                     s.top = s.axis.y + n.cylinder().height;
                     s.bottom = s.axis.y;
                 }),
        in_steps("center at a cap",
                 [](Steps& s, const Names& n) {
                     s.top = s.axis.y;
                     s.bottom = s.axis.y - n.cylinder().height;
                 }),
        in_choice("larger root", [](const auto& hits) { return hits.back(); }),
        in_choice("hit behind the start", [](const auto& hits) { return hits.front(); }),
        in_steps("radius not squared", [](Steps& s, const Names& n) { s.tube_square = n.cylinder().radius; }),
        in_steps("radius not squared",
                 [](Steps& s, const Names& n) { s.tube_square = s.cap_square = n.cylinder().radius; }),
        in_steps("center forgotten", [](Steps& s, const Names&) { s.axis = vec3(0); }),
        in_steps("center forgotten", [](Steps& s, const Names&) { s.axis = s.cap_axis = vec3(0); }),
        in_steps("center forgotten",
                 [](Steps& s, const Names& n) {
                     s.axis = s.cap_axis = vec3(0);
                     s.top = n.cylinder().height / 2;
                     s.bottom = -s.top;
                 }),
        in_steps("center forgotten",
                 [](Steps& s, const Names& n) {
                     s.top = n.cylinder().height / 2;
                     s.bottom = -s.top;
                 }),
        in_steps("y in the tube's equation", [](Steps& s, const Names&) { s.y_too = true; }),
        in_steps("ray starts at the eye", [](Steps& s, const Names& n) { s.S = n.eye(); }),
    };
}

std::vector<NamedMistake> of_tube_root() {
    const auto root = [](auto compute) {
        return [=](const Names& n) {
            const float p = n.at(tube::a);
            return p == 0 ? NAN : compute(p, n.at(tube::b), std::sqrt(n.at(tube::d)));
        };
    };
    return {
        on("not divided by 2", tube::t, root([](float p, float q, float e) { return (-q - e) / p; })),
        on("square root forgotten", tube::t, root([](float p, float q, float e) { return (-q - e * e) / (2 * p); })),
        on("sign of b in the root", tube::t, root([](float p, float q, float e) { return (q - e) / (2 * p); })),
        on("sign of b in the root", tube::t, root([](float p, float q, float e) { return (q + e) / (2 * p); })),
        on("operator precedence", tube::t, root([](float p, float q, float e) { return (-q - e) / 2 * p; })),
        on("operator precedence", tube::t, root([](float p, float q, float e) { return -q - e / (2 * p); })),
        on("factor 4 missing", tube::t,
           [](const Names& n) {
               const float p = n.at(tube::a), q = n.at(tube::b);
               return (-q - std::sqrt(q * q - p * n.at(tube::c))) / (2 * p);
           }),
    };
}

std::vector<NamedMistake> of_tube_point() {
    const auto center = [](const Names& n) { return n.cylinder().center; };
    const auto level = [](const vec3& p) { return vec3(p.x, 0, p.z); };
    const auto hit = [](const Names& n) { return n.vec(tube::hit); };
    const auto is_on_cap = [=](const Names& n) {
        return std::abs(std::abs(hit(n).y - center(n).y) - n.cylinder().height / 2) < 1e-4F;
    };
    const auto on_cap = [=](std::string_view name, auto formula) {
        return NamedMistake{name, {tube::normal, [=](const Program& p, const auto& right) {
                                       return is_on_cap(Names(p)) ? floats(formula(Names(p))) : right;
                                   }}};
    };
    const auto on_tube = [=](std::string_view name, auto formula) {
        return NamedMistake{name, {tube::normal, [=](const Program& p, const auto& right) {
                                       return is_on_cap(Names(p)) ? right : floats(formula(Names(p)));
                                   }}};
    };
    return {
        on("ray starts at the eye", tube::hit, [](const Names& n) { return n.eye() + n.at(tube::t) * n.direction(); }),
        on("start forgotten", tube::hit, [](const Names& n) { return n.at(tube::t) * n.direction(); }),
        on("sign of t", tube::hit, [](const Names& n) { return n.S() - n.at(tube::t) * n.direction(); }),
        on_cap("wrong cap's normal", [=](const Names& n) { return vec3(0, hit(n).y > center(n).y ? -1 : 1, 0); }),
        on_cap("tube's normal for a cap", [=](const Names& n) { return normalize(level(hit(n) - center(n))); }),
        on_cap("tube's normal for a cap", [=](const Names& n) { return normalize(level(hit(n))); }),
        on_tube("center forgotten", [=](const Names& n) { return normalize(level(hit(n))); }),
        on_tube("points inward", [=](const Names& n) { return -normalize(level(hit(n) - center(n))); }),
        on_tube("not normalized", [=](const Names& n) { return level(hit(n) - center(n)); }),
        on_tube("not normalized", [=](const Names& n) { return level(hit(n)); }),
        on_tube("y in the normal", [=](const Names& n) { return normalize(hit(n) - center(n)); }),
        on_tube("y in the normal", [=](const Names& n) { return normalize(hit(n)); }),
        on_tube("cap's normal for the tube", [](const Names&) { return vec3(0, 1, 0); }),
        on_tube("cap's normal for the tube", [](const Names&) { return vec3(0, -1, 0); }),
        on_tube("sign of the center", [=](const Names& n) { return normalize(level(hit(n) + center(n))); }),
    };
}

}  // namespace

std::vector<NamedMistake> of_cylinder() {
    std::vector<NamedMistake> all;
    for (const auto& part : {of_tube_coefficients(), of_parts(), of_tube_root(), of_tube_point()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace student
