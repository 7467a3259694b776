#include "harness/report/accuracy/price.h"

#include <fmt/format.h>

#include <optional>

#include "harness/report/accuracy/numbers.h"
#include "harness/report/accuracy/summary.h"
#include "harness/text/listed.h"

namespace harness::report {
namespace {

using reference::accuracy::Measurement;
using reference::accuracy::Primitive;
using reference::accuracy::Row;

/// The fastest row of this shape and certainty; null if there is none.
const Row* fastest(const PrimitiveSummary& summary, const Price& shape, bool certain) {
    const Row* found = nullptr;
    for (const MethodSummary& method : summary.methods) {
        const Row& row = method.row;
        if (row.hard) continue;  // not timed on benign rays
        if (row.certain != certain || row.scalar != shape.scalar || row.gives_t != shape.gives_t) continue;
        if (found == nullptr || row.ns_per_ray < found->ns_per_ray) found = &row;
    }
    return found;
}

std::optional<Price> price_of(const PrimitiveSummary& summary, Price price) {
    const Row* const certain = fastest(summary, price, true);
    const Row* const rival = fastest(summary, price, false);
    if (certain == nullptr || rival == nullptr) return std::nullopt;
    price.certain = certain->kernel;
    price.rival = rival->kernel;
    price.ns = {certain->ns_low, certain->ns_per_ray, certain->ns_high};
    price.rival_ns = {rival->ns_low, rival->ns_per_ray, rival->ns_high};
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
    std::vector<Price> found;
    for (const PrimitiveSummary& summary : summarize(measured)) {
        for (const bool gives_t : {true, false}) {
            for (const char* scalar : {"double", "float"}) {
                const auto price = price_of(summary, {summary.primitive, scalar, gives_t, "", ""});
                if (price) found.push_back(*price);
            }
        }
    }
    return found;
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
