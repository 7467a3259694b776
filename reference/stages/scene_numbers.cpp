#include "reference/stages/scene_numbers.h"

#include <memory>
#include <stdexcept>

namespace reference {
namespace {

Rational exact(const Decimal& number) {
    const std::optional<Rational> x = to_rational(number);
    if (!x) throw std::domain_error(number.text() + " is too large or too small for a certified key");
    return *x;
}

}  // namespace

Scene<Rational> rational_scene(const Scene<Decimal>& scene) {
    return convert_scene<Rational>(scene, exact);
}

Scene<Certified> certified_scene(const Scene<Rational>& scene) {
    const auto basis = std::make_shared<RootBasis>();
    return convert_scene<Certified>(scene, [&](const Rational& x) { return Certified(FieldNumber(x, basis)); });
}

}  // namespace reference
