#include "harness/report/picture/object_sketch.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>

namespace harness::report::picture {

using reference::AnswerKey;
using reference::ItemId;
using reference::Numbers;

const Numbers* numbers_of(const AnswerKey& key, const ItemId& id) {
    const reference::KeyItem* asked = reference::asked_item(key, id);
    return asked == nullptr ? nullptr : std::get_if<Numbers>(&asked->answers.front().value);
}

std::optional<Point> point_of(const AnswerKey& key, const ItemId& id) {
    const Numbers* numbers = numbers_of(key, id);
    if (numbers == nullptr || numbers->size() != 3) return std::nullopt;
    const Point point((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    return is_finite(point) ? std::optional(point) : std::nullopt;
}

double number_of(const AnswerKey& key, const ItemId& id) {
    const Numbers* numbers = numbers_of(key, id);
    return numbers != nullptr && numbers->size() == 1 ? numbers->front() : std::nan("");
}

std::string hit_note(std::string_view object, std::string_view point, double t) {
    if (std::isnan(t)) return fmt::format("{}: the ray hits the {}.", point, object);
    return fmt::format("{}: the ray hits the {}, t = {:.4g}.", point, object, t);
}

}  // namespace harness::report::picture
