#include "tests/reference/stages/cylinder_cases.h"

#include <random>

namespace {

using namespace reference;
using Point = Vec3<Rational>;

class Draw {
  public:
    explicit Draw(std::uint64_t seed) : engine_(seed) {}
    int whole(int least, int most) {
        return least + static_cast<int>(engine_() % static_cast<std::uint64_t>(most - least + 1));
    }
    /// A fraction from -size to size.
    Rational number(int size) { return fraction(whole(-8 * size, 8 * size), whole(1, 8) * 8); }
    Rational positive(int size) { return fraction(whole(1, 8 * size), 8); }
    Point point(int size) { return {number(size), number(size), number(size)}; }
    /// cos and sin of an angle, both rational.
    std::pair<Rational, Rational> angle() {
        const Rational p = number(4);
        const Rational square = p * p;
        std::pair<Rational, Rational> result((1 - square) / (1 + square), 2 * p / (1 + square));
        if (whole(0, 1) == 0) std::swap(result.first, result.second);
        if (whole(0, 1) == 0) result.first = -result.first;
        return result;
    }
    /// 0, or a little above or below it.
    Rational nudge(int bits) {
        return whole(0, 2) == 0 ? Rational(whole(0, 1) * 2 - 1) / (mpz_class(1) << bits) : Rational(0);
    }

  private:
    static Rational fraction(int numerator, int denominator) {
        Rational result(numerator, denominator);
        result.canonicalize();
        return result;
    }
    std::mt19937_64 engine_;
};

Point times(const Point& p, const Rational& factor) {
    return {p.x * factor, p.y * factor, p.z * factor};
}

Point nudged(const Point& p, Draw& draw, int bits) {
    return {p.x + draw.nudge(bits), p.y + draw.nudge(bits), p.z + draw.nudge(bits)};
}

Rational power_of_two(int exponent) {
    const Rational power(mpz_class(1) << static_cast<mp_bitcnt_t>(std::abs(exponent)));
    return exponent < 0 ? Rational(1 / power) : power;
}

}  // namespace

CylinderCase cylinder_case(std::uint64_t seed) {
    enum Aim { rim, tube, cap, inside, anywhere, aims };
    enum Way { any_way, horizontal, vertical, tangent, ways };
    enum From { before, in, behind, froms };
    const auto aim_at = static_cast<Aim>(seed % aims);
    const auto way = static_cast<Way>(seed / aims % ways);
    const auto from = static_cast<From>(seed / aims / ways % froms);
    Draw draw(seed);
    Cylinder<Rational> cylinder{draw.point(5), draw.positive(4), draw.positive(6)};
    const auto [cos, sin] = draw.angle();
    const Rational half = cylinder.height / 2;
    const Rational share = draw.number(1) * Rational(7, 8);
    const Rational out = aim_at == rim || aim_at == tube ? Rational(1) : Rational(share * share);
    const Rational up = aim_at == rim || aim_at == cap ? Rational(2 * draw.whole(0, 1) - 1) : draw.number(1);
    Point aim(cylinder.center.x + out * cylinder.radius * cos, cylinder.center.y + up * half,
              cylinder.center.z + out * cylinder.radius * sin);
    if (aim_at == anywhere) aim = cylinder.center + draw.point(12);
    Point V = draw.point(3);
    if (way == horizontal) V.y = 0;
    if (way == vertical) V = Point(0, draw.whole(0, 1) * 2 - 1, 0);
    if (way == tangent) V = Point(-sin, draw.whole(0, 1) == 0 ? Rational(0) : draw.number(2), cos);
    if (V == Point(0, 0, 0)) V = Point(cos, 1, sin);
    const Rational distance = from == in       ? Rational(0)
                              : from == before ? draw.positive(9)
                                               : Rational(-draw.positive(9));
    Point start = aim - times(V, distance);
    if (draw.whole(0, 2) == 0) start = nudged(start, draw, 40 * draw.whole(1, 2));
    const Rational scale = draw.whole(0, 1) == 0 ? Rational(1) : power_of_two(draw.whole(-60, 60));
    cylinder = {times(cylinder.center, scale), cylinder.radius * scale, cylinder.height * scale};
    return {times(start, scale), times(V, power_of_two(draw.whole(-3, 3))), cylinder};
}
