#include "reference/numbers/certified.h"

#include <stdexcept>
#include <utility>

namespace reference {

struct Certified::Node {
    Operation operation;
    FieldNumber exact;                        ///< the value, if the operation is `exact`
    std::shared_ptr<const Node> x = nullptr;  ///< otherwise the operands
    std::shared_ptr<const Node> y = nullptr;
    mutable Ball known = {};  ///< the last evaluation, to known_bits
    mutable Bits known_bits = 0;

    static const Ball& evaluate(const Node& node, Bits bits) {
        if (node.known_bits == bits) return node.known;
        node.known = node.computed(bits);
        node.known_bits = bits;
        return node.known;
    }

    Ball computed(Bits bits) const {
        switch (operation) {
            case Operation::exact: return exact.ball(bits);
            case Operation::add: return Ball::add(evaluate(*x, bits), evaluate(*y, bits), bits);
            case Operation::subtract: return Ball::subtract(evaluate(*x, bits), evaluate(*y, bits), bits);
            case Operation::multiply: return Ball::multiply(evaluate(*x, bits), evaluate(*y, bits), bits);
            case Operation::divide: return Ball::divide(evaluate(*x, bits), evaluate(*y, bits), bits);
            case Operation::sqrt: return evaluate(*x, bits).sqrt(bits);
        }
        throw std::logic_error("an operation without a rule");
    }
};

Certified::Certified(FieldNumber x) : node_(std::make_shared<Node>(Node{Operation::exact, std::move(x)})) {}

Certified::Certified(Operation operation, const Certified& x, const Certified& y)
    : node_(std::make_shared<Node>(Node{operation, {}, x.node_, y.node_})) {}

const FieldNumber* Certified::exact() const {
    return node_->operation == Operation::exact ? &node_->exact : nullptr;
}

Ball Certified::ball(Bits bits) const {
    return Node::evaluate(*node_, bits);
}

Certified operator+(const Certified& x, const Certified& y) {
    const FieldNumber* p = x.exact();
    const FieldNumber* q = y.exact();
    if (p != nullptr && q != nullptr) return Certified(*p + *q);
    if (p != nullptr && p->is_zero()) return y;
    if (q != nullptr && q->is_zero()) return x;
    return Certified(Certified::Operation::add, x, y);
}

Certified operator-(const Certified& x, const Certified& y) {
    const FieldNumber* p = x.exact();
    const FieldNumber* q = y.exact();
    if (p != nullptr && q != nullptr) return Certified(*p - *q);
    if (q != nullptr && q->is_zero()) return x;
    return Certified(Certified::Operation::subtract, x, y);
}

Certified operator*(const Certified& x, const Certified& y) {
    const FieldNumber* p = x.exact();
    const FieldNumber* q = y.exact();
    if (p != nullptr && q != nullptr) return Certified(*p * *q);
    if (p != nullptr && p->is_zero()) return x;
    if (q != nullptr && q->is_zero()) return y;
    return Certified(Certified::Operation::multiply, x, y);
}

Certified operator/(const Certified& x, const Certified& y) {
    const FieldNumber* p = x.exact();
    const FieldNumber* q = y.exact();
    if (p != nullptr && q != nullptr) return Certified(*p * q->inverse());
    if (q != nullptr && q->is_zero()) throw std::domain_error("division by zero");
    if (p != nullptr && p->is_zero()) return x;
    return Certified(Certified::Operation::divide, x, y);
}

Certified sqrt(const Certified& x) {
    if (const FieldNumber* p = x.exact()) {
        if (p->sign() < 0) throw std::domain_error("square root of a negative number");
        if (const std::optional<FieldNumber> root = p->sqrt()) return Certified(*root);
    }
    return Certified(Certified::Operation::sqrt, x, x);
}

std::partial_ordering sign_of(const Certified& x) {
    if (const FieldNumber* p = x.exact()) return p->sign();
    for (Bits bits = first_bits; bits <= most_bits; bits *= 2) {
        const std::partial_ordering sign = x.ball(bits).sign();
        if (sign != std::partial_ordering::unordered) return sign;
    }
    return std::partial_ordering::unordered;
}

Enclosure Certified::enclosure() const {
    if (const FieldNumber* p = exact()) {
        if (const std::optional<Rational> value = p->rational()) return enclose(*value);
    }
    Bits bits = first_bits;
    while (bits < most_bits && !ball(bits).settles_a_double()) bits *= 2;
    return ball(bits).enclosure();
}

}  // namespace reference
