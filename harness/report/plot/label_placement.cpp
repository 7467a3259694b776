// Coordinate descent: each label in turn goes where it costs least while the others stay, until none moves. A place
// costs its distance from the point, much more if it hides something or its leader line crosses something, and most if
// it overlaps another label.
#include "harness/report/plot/label_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>

namespace harness::report {
namespace {

constexpr double gap = 2;           ///< between two labels, and a label and a point's mark
constexpr double mark_radius = 6;   ///< of a point
constexpr double first_radius = 9;  ///< of the nearest places, from the point's middle to the label
constexpr double growth = 0.3;      ///< each radius is larger than the one before by this share,
constexpr double most_growth = 17;  ///< but no more than this: the height of a label and its gap
constexpr int directions = 32;
constexpr int most_passes = 12;

constexpr double price_of_label = 1e6;
constexpr double price_of_mark = 2e4;
constexpr double price_of_leader_over_label = 1500;
constexpr double price_of_crossing = 200;
constexpr double price_of_leader_over_mark = 1000;
constexpr double price_of_doubt = 40;  ///< for a label nearer to another point than to its own

/// A far place costs more than its distance, so that no single label goes far away to spare many others a little. A
/// label reads best level with its point, preferably to the right.
double price_of_place(double radius, double angle) {
    constexpr double far = 10;
    constexpr double slant = 4;
    constexpr double leftward = 0.5;
    return radius + radius * radius / far + slant * std::abs(std::sin(angle)) + (std::cos(angle) < 0 ? leftward : 0);
}

bool overlap(const Box& one, const Box& other, double margin) {
    return one.left < other.right + margin && other.left < one.right + margin && one.top < other.bottom + margin &&
           other.top < one.bottom + margin;
}

double side(const Spot& from, const Spot& to, const Spot& point) {
    return (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x);
}

bool cross(const Segment& one, const Segment& other) {
    return side(one.from, one.to, other.from) * side(one.from, one.to, other.to) < 0 &&
           side(other.from, other.to, one.from) * side(other.from, other.to, one.to) < 0;
}

bool contains(const Box& box, const Spot& spot) {
    return spot.x > box.left && spot.x < box.right && spot.y > box.top && spot.y < box.bottom;
}

bool passes(const Segment& line, const Box& box) {
    const bool is_beside = std::max(line.from.x, line.to.x) < box.left ||
                           std::min(line.from.x, line.to.x) > box.right || std::max(line.from.y, line.to.y) < box.top ||
                           std::min(line.from.y, line.to.y) > box.bottom;
    if (is_beside) return false;
    return contains(box, line.from) || contains(box, line.to) ||
           cross(line, {{box.left, box.top}, {box.right, box.bottom}}) ||
           cross(line, {{box.left, box.bottom}, {box.right, box.top}});
}

double distance(const Spot& one, const Spot& other) {
    // Not hypot, which may round differently on another machine and takes longer.
    const double x = one.x - other.x;
    const double y = one.y - other.y;
    return std::sqrt(x * x + y * y);
}

double distance(const Segment& line, const Spot& spot) {
    const double length = distance(line.from, line.to);
    if (length == 0) return distance(line.from, spot);
    const double along =
        ((spot.x - line.from.x) * (line.to.x - line.from.x) + (spot.y - line.from.y) * (line.to.y - line.from.y)) /
        (length * length);
    const double share = std::clamp(along, 0.0, 1.0);
    return distance(
        Spot{line.from.x + share * (line.to.x - line.from.x), line.from.y + share * (line.to.y - line.from.y)}, spot);
}

Box mark_of(const Label& label) {
    return {label.point.x - mark_radius, label.point.y - mark_radius, label.point.x + mark_radius,
            label.point.y + mark_radius};
}

struct Place {
    Box box;
    double price;                       ///< of the position alone
    std::optional<double> hiding = {};  ///< price of what it hides, except other labels; computed when first needed
};

std::vector<Place> places_for(const Label& label, const Box& area, double most) {
    std::vector<Place> places;
    const double farthest = std::min(most, std::hypot(area.right - area.left, area.bottom - area.top));
    for (double radius = first_radius; radius < farthest; radius += std::min(growth * radius, most_growth)) {
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * std::numbers::pi * i / directions;
            const double x = label.point.x + std::cos(angle) * (radius + label.width / 2);
            const double y = label.point.y - std::sin(angle) * (radius + label.height / 2);
            const Box box{x - label.width / 2, y - label.height / 2, x + label.width / 2, y + label.height / 2};
            if (box.left < area.left || box.right > area.right || box.top < area.top || box.bottom > area.bottom)
                continue;
            places.push_back({box, price_of_place(radius, angle), std::nullopt});
        }
    }
    return places;
}

/// The places of all labels and their prices without the other labels. Prices are computed on demand: most are never
/// needed, as a near place that hides nothing is cheaper.
class Places {
  public:
    Places(const std::vector<Label>& labels, const Box& area, const std::vector<Segment>& drawn,
           const PlaceSearch& search)
        : labels_(labels), drawn_(drawn), search_(search) {
        for (const Label& label : labels) places_.push_back(places_for(label, area, search.farthest));
    }

    std::vector<Place>& of(std::size_t i) { return places_[i]; }

    /// The price of one of label i's places.
    double price(std::size_t i, Place& place) {
        if (!place.hiding) place.hiding = price_of_hiding(labels_[i], place.box);
        return place.price + *place.hiding;
    }

    bool is_taken(const Box& place) const {
        return std::any_of(search_.taken.begin(), search_.taken.end(),
                           [&](const Box& box) { return overlap(place, box, 0); });
    }

  private:
    double price_of_hiding(const Label& label, const Box& place) const {
        const Segment leader{label.point, nearest_on(place, label.point)};
        const double away = distance(leader.from, leader.to);
        double price = is_taken(place) ? price_of_label : 0;
        for (const Box& box : search_.taken) {
            if (passes(leader, box) && !contains(box, label.point)) price += price_of_leader_over_label;
        }
        for (const Label& other : labels_) {
            if (overlap(place, mark_of(other), 0)) price += price_of_mark;
            if (distance(other.point, label.point) <= mark_radius) continue;
            if (distance(leader, other.point) < mark_radius) price += price_of_leader_over_mark;
            if (distance(nearest_on(place, other.point), other.point) < std::min(away, 24.0)) price += price_of_doubt;
        }
        for (const Segment& line : drawn_) {
            if (passes(line, place)) price += search_.price_of_drawn;
        }
        return price;
    }

    const std::vector<Label>& labels_;
    const std::vector<Segment>& drawn_;
    const PlaceSearch& search_;
    std::vector<std::vector<Place>> places_;
};

class Arrangement {
  public:
    Arrangement(const std::vector<Label>& labels, Places& places)
        : labels_(&labels), places_(&places), chosen_(labels.size()), prices_(labels.size()) {}

    /// Returns whether any label moved.
    bool pass(const std::vector<std::size_t>& order) {
        bool moved = false;
        for (const std::size_t i : order) {
            std::optional<Box> best;
            double least = std::numeric_limits<double>::infinity();
            for (Place& place : places_->of(i)) {
                if (place.price >= least) continue;
                const double own = places_->price(i, place);
                if (own >= least) continue;
                const double price = own + price_among_others(i, place.box, least);
                if (price >= least) continue;
                least = price;
                best = place.box;
                prices_[i] = own;
            }
            moved = moved || !best || !chosen_[i] || best->left != chosen_[i]->left || best->top != chosen_[i]->top;
            chosen_[i] = best;
        }
        return moved;
    }

    double price() const {
        constexpr double unplaced = 1e9;
        double sum = 0;
        for (std::size_t i = 0; i < chosen_.size(); ++i) {
            if (!chosen_[i]) return unplaced;
            sum += prices_[i] + price_among_others(i, *chosen_[i], unplaced);
        }
        return sum;
    }

    Placement placement() const {
        Placement placement{{}, true};
        for (std::size_t i = 0; i < labels_->size(); ++i) {
            placement.is_clear = placement.is_clear && chosen_[i];
            placement.boxes.push_back(chosen_[i].value_or(mark_of((*labels_)[i])));
        }
        for (std::size_t i = 0; i < labels_->size(); ++i) {
            for (std::size_t j = 0; j < labels_->size(); ++j) {
                if (j < i && overlap(placement.boxes[i], placement.boxes[j], gap)) placement.is_clear = false;
                if (overlap(placement.boxes[i], mark_of((*labels_)[j]), 0)) placement.is_clear = false;
            }
            if (places_->is_taken(placement.boxes[i])) placement.is_clear = false;
        }
        return placement;
    }

  private:
    double price_among_others(std::size_t i, const Box& place, double enough) const {
        const Segment leader{(*labels_)[i].point, nearest_on(place, (*labels_)[i].point)};
        double price = 0;
        for (std::size_t j = 0; j < labels_->size() && price < enough; ++j) {
            if (j == i || !chosen_[j]) continue;
            const Segment other{(*labels_)[j].point, nearest_on(*chosen_[j], (*labels_)[j].point)};
            if (overlap(place, *chosen_[j], gap)) price += price_of_label;
            if (passes(leader, *chosen_[j])) price += price_of_leader_over_label;
            if (passes(other, place)) price += price_of_leader_over_label;
            if (cross(leader, other)) price += price_of_crossing;
        }
        return price;
    }

    const std::vector<Label>* labels_;
    Places* places_;
    std::vector<std::optional<Box>> chosen_;
    std::vector<double> prices_;  ///< of each label's place, without the other labels
};

/// The first labels find the best places, so many orders are tried.
std::vector<std::vector<std::size_t>> orders_of(const std::vector<Label>& labels, int shuffled) {
    std::vector<std::size_t> order(labels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<std::vector<std::size_t>> orders{order};
    const auto add = [&](auto key) {
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t one, std::size_t other) { return key(labels[one]) < key(labels[other]); });
        orders.push_back(order);
        orders.emplace_back(order.rbegin(), order.rend());
    };
    add([](const Label& label) { return label.point.y; });
    add([](const Label& label) { return label.point.x; });
    add([](const Label& label) { return label.width; });
    std::mt19937 random(1);  // NOLINT(cert-msc51-cpp): the same picture every time
    for (int i = 0; i < shuffled; ++i) {
        // std::shuffle may give another order with another standard library.
        for (std::size_t last = order.size(); last > 1; --last) std::swap(order[last - 1], order[random() % last]);
        orders.push_back(order);
    }
    return orders;
}

}  // namespace

Spot nearest_on(const Box& box, const Spot& point) {
    return {std::clamp(point.x, box.left, box.right), std::clamp(point.y, box.top, box.bottom)};
}

Placement place_labels(const std::vector<Label>& labels, const Box& area, const std::vector<Segment>& drawn,
                       const PlaceSearch& search) {
    Places places(labels, area, drawn, search);
    std::optional<Arrangement> best;
    for (const std::vector<std::size_t>& order : orders_of(labels, search.shuffled)) {
        Arrangement arrangement(labels, places);
        for (int i = 0; i < most_passes && arrangement.pass(order); ++i) {
        }
        if (!best || arrangement.price() < best->price()) best = std::move(arrangement);
    }
    return best->placement();
}

}  // namespace harness::report
