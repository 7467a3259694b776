#include "harness/mark/compare/quadratic_form.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace harness {
namespace {

/// Whether the printed d may be b^2 - factor ac, given the digits of all four numbers and four float roundings.
bool is_possible(const PrintedNumber& d, const PrintedNumber& a, const PrintedNumber& b, const PrintedNumber& c,
                 const Interval& factor, Digits digits) {
    const Interval square = enclosure_of(b, digits) * enclosure_of(b, digits);
    const Interval product = factor * enclosure_of(a, digits) * enclosure_of(c, digits);
    const Interval given = enclosure_of(d, digits);
    const double roundings =
        4 * 0x1p-24 * (std::abs(square.hi()) + std::max(std::abs(product.lo()), std::abs(product.hi())));
    const Interval difference = square - product + Interval(-roundings, roundings);
    return given.lo() <= difference.hi() && difference.lo() <= given.hi();
}

/// Whether the number is the target, within its allowance, divided by `divisor` and multiplied by `factor`.
bool is_right_multiple(const PrintedNumber& number, const Target& target, int divisor, const Interval& factor,
                       int min_decimals) {
    return is_multiple(number, target.components.front() / Interval(divisor), factor, target.allowance.front(),
                       min_decimals);
}

QuadraticForm find_quadratic_form(const PrintedQuadratic& printed, std::span<const ItemTargets> keys,
                                  int min_decimals) {
    const PrintedNumber* a = single_number(printed.a);
    const PrintedNumber* b = single_number(printed.b);
    const PrintedNumber* c = single_number(printed.c);
    const PrintedNumber* d = single_number(printed.d);
    if (a == nullptr || b == nullptr || c == nullptr || d == nullptr) return QuadraticForm::full;
    const auto is_discriminant = [&](const Interval& factor) {
        return is_possible(*d, *a, *b, *c, factor, Digits::as_printed) ||
               is_possible(*d, *a, *b, *c, factor, Digits::of_stream);
    };
    const auto is_key = [&](const PrintedNumber& number, std::string_view name, int divisor) {
        return std::any_of(keys.begin(), keys.end(), [&](const ItemTargets& key) {
            const Target* target = key.number({printed.object, name});
            return target != nullptr && is_right_multiple(number, *target, divisor, Interval(1.0), min_decimals);
        });
    };
    const bool is_whole = is_key(*b, "b", 1), is_half = is_key(*b, "b", 2);
    const QuadraticForm by_b = is_half && !is_whole ? QuadraticForm::half_b : QuadraticForm::full;
    // If d fits neither form of the printed b, b decides, unless d is right in the full form.
    if (!is_discriminant(Interval(1)))
        return is_discriminant(Interval(4)) || is_key(*d, "d", 1) ? QuadraticForm::full : by_b;
    if (is_discriminant(Interval(4))) return by_b;
    const PrintedNumber* t = single_number(printed.t);
    const auto is_root_in = [&](QuadraticForm form) {
        const auto known = [](const PrintedNumber& number) { return enclosure_of(number, Digits::as_printed); };
        return is_root(known(*t), known(*a), known(*b), known(*c), form);
    };
    const bool is_half_root = t != nullptr && std::isfinite(t->value) && is_root_in(QuadraticForm::half_b) &&
                              !is_root_in(QuadraticForm::full);
    return is_whole && !is_half && !is_half_root ? QuadraticForm::full : QuadraticForm::half_b;
}

/// The printed a, b and c divided by the key's; empty if they have no common factor or the factor is 1.
std::optional<Interval> find_factor(const PrintedQuadratic& printed, const ItemTargets& key, QuadraticForm form,
                                    int min_decimals) {
    const PrintedNumber* a = single_number(printed.a);
    const PrintedNumber* b = single_number(printed.b);
    const PrintedNumber* c = single_number(printed.c);
    const Target* key_a = key.number({printed.object, "a"});
    const Target* key_b = key.number({printed.object, "b"});
    const Target* key_c = key.number({printed.object, "c"});
    if (a == nullptr || b == nullptr || c == nullptr || key_a == nullptr || key_b == nullptr || key_c == nullptr)
        return std::nullopt;
    const int b_divisor = form == QuadraticForm::half_b ? 2 : 1;
    const auto multiplied_by = [&](const Interval& factor) {
        return is_right_multiple(*b, *key_b, b_divisor, factor, min_decimals) &&
               is_right_multiple(*c, *key_c, 1, factor, min_decimals);
    };
    // The factor is 1 if b and c are right and a is wrong, or if the digits are too few to tell.
    if (is_right_multiple(*a, *key_a, 1, Interval(1.0), min_decimals) || multiplied_by(Interval(1.0)))
        return std::nullopt;
    const Interval factor = enclosure_of(*a, Digits::as_printed) / key_a->components.front();
    return multiplied_by(factor) ? std::optional(factor) : std::nullopt;
}

}  // namespace

bool is_root(const Interval& t, const Interval& a, const Interval& b, const Interval& c, QuadraticForm form) {
    const Interval factor(form == QuadraticForm::half_b ? 2 : 1);
    return (t * (a * t + factor * b) + c).contains(0);
}

QuadraticScale find_quadratic_scale(const PrintedQuadratic& printed, std::span<const ItemTargets> keys,
                                    int min_decimals) {
    QuadraticScale scale;
    scale.form = find_quadratic_form(printed, keys, min_decimals);
    for (const ItemTargets& key : keys) {
        const auto factor = find_factor(printed, key, scale.form, min_decimals);
        if (!factor) continue;
        scale.factor = *factor;
        break;
    }
    return scale;
}

}  // namespace harness
