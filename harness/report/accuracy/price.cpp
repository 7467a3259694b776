#include "harness/report/accuracy/price.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/summary.h"
#include "harness/text/listed.h"

namespace harness::report {
namespace {

using reference::accuracy::Measurement;
using reference::accuracy::Primitive;
using reference::accuracy::Quartiles;

struct Contestant {
    Price shape;  ///< without its methods
    std::string name;
    bool certain;
    Quartiles ns;
    std::optional<double> latency;
};

std::vector<Contestant> contestants_of(const Measurement& measured) {
    std::vector<Contestant> all;
    for (const PrimitiveSummary& summary : summarize(measured)) {
        if (summary.benign.empty()) continue;
        for (const MethodSummary& method : summary.methods) {
            if (!(method.ns > 0)) continue;  // not measured on benign rays
            all.push_back({{summary.primitive, method.scalar, method.gives_t, "", ""},
                           method.kernel,
                           method.certain,
                           {method.ns_low, method.ns, method.ns_high},
                           method.latency});
        }
    }
    return all;
}

bool is_same_shape(const Price& one, const Price& other) {
    return one.primitive == other.primitive && one.scalar == other.scalar && one.gives_t == other.gives_t;
}

/// The contestant of this shape and certainty with the least figure; null if there is none.
template <class Figure>
const Contestant* best(const std::vector<Contestant>& all, const Price& shape, bool certain, Figure figure) {
    const Contestant* found = nullptr;
    for (const Contestant& one : all) {
        if (one.certain != certain || !is_same_shape(one.shape, shape)) continue;
        if (found == nullptr || figure(one) < figure(*found)) found = &one;
    }
    return found;
}

std::optional<Price> price_of(const std::vector<Contestant>& all, Price price) {
    const auto time = [](const Contestant& one) { return one.ns.median; };
    const auto latency = [](const Contestant& one) { return one.latency.value_or(HUGE_VAL); };
    const Contestant* const certain = best(all, price, true, time);
    const Contestant* const rival = best(all, price, false, time);
    if (certain == nullptr || rival == nullptr) return std::nullopt;
    price.certain = certain->name;
    price.rival = rival->name;
    price.ns = certain->ns;
    price.rival_ns = rival->ns;
    const auto chained = best(all, price, true, latency)->latency;
    const auto rival_chained = best(all, price, false, latency)->latency;
    if (chained && rival_chained) price.times_in_a_chain = *chained / *rival_chained;
    return price;
}

std::string in_words(Primitive primitive) {
    switch (primitive) {
        case Primitive::sphere: return "a sphere";
        case Primitive::triangle: return "a triangle";
        case Primitive::cast: return "a whole cast";
    }
    return "";
}

}  // namespace

std::vector<Price> prices(const Measurement& measured) {
    const std::vector<Contestant> all = contestants_of(measured);
    std::vector<Price> found;
    for (const Primitive primitive : {Primitive::sphere, Primitive::triangle, Primitive::cast}) {
        for (const bool gives_t : {true, false}) {
            for (const char* scalar : {"double", "float"}) {
                const auto price = price_of(all, {primitive, scalar, gives_t, "", ""});
                if (price) found.push_back(*price);
            }
        }
    }
    return found;
}

std::string shape_text(const Price& price) {
    return fmt::format("{}, {}", price.gives_t ? "with t" : "decision", price.scalar);
}

std::string price_sentence(const std::vector<Price>& prices) {
    std::vector<std::string> parts;
    for (const Price& price : prices) {
        if (!price.gives_t || price.scalar != "double") continue;
        parts.push_back(fmt::format("{:.2f} times as long for {} ({} ns beside {})", price.times(),
                                    in_words(price.primitive), three_digits(price.ns.median),
                                    three_digits(price.rival_ns.median)));
    }
    if (parts.empty()) return "";
    return "Never to be wrong takes " + listed(parts) +
           " as the fastest formula that rounds: a hit with its t, one ray at a time, in double.";
}

}  // namespace harness::report
