#include "harness/report/picture/printed_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/read/transcript.h"
#include "harness/report/picture/object_sketch.h"
#include "harness/report/picture/scene_sketch.h"

namespace harness::report::picture {
namespace {

namespace item = reference::item;
using reference::ItemId;

/// What the picture calls an item.
std::string name_of(const reference::ItemSpec& spec) {
    if (spec.id.name == "hit") return std::string(spec.label);
    if (spec.id.name == "normal") return fmt::format("N_{}", to_string(spec.id.subject).front());  // as P_s is named
    return std::string(spec.id.name);
}

std::string name_in_notes(const reference::ItemSpec& spec) {
    return fmt::format("{} (question {})", name_of(spec), spec.question);
}

std::string shortened(const std::string& printed) {
    constexpr std::size_t longest = 48;
    return printed.size() <= longest ? printed : printed.substr(0, longest) + "...";
}

struct Answer {
    Point value;
    bool is_right = false;

    Mark mark() const { return is_right ? Mark::ring : Mark::cross; }
    Stroke stroke() const { return is_right ? Stroke::plain : Stroke::dashed; }
};

/// Draws one submission's answers; the sketch grows call by call.
class PrintedDrawing {
  public:
    PrintedDrawing(const Score& score, const DoubleScene& scene, const RightValues* right, const Frame& frame)
        : score_(score), scene_(scene), right_(right), frame_(frame) {}

    PrintedSketch draw() {
        draw_P_VCS();
        draw_basis();
        draw_ray();
        reference::for_each_kind([&](reference::Subject kind, const auto& objects) { draw_object(kind, objects); },
                                 scene_);
        return std::move(result_);
    }

  private:
    /// Empty if what was printed can't be drawn, which is noted, or if it is right and need not be drawn.
    std::optional<Answer> answer(const ItemId& id) {
        const ItemScore* item = find(id);
        if (item == nullptr || item->printed.empty()) return std::nullopt;
        const bool is_right = item->verdict == ItemVerdict::right;
        if (is_right && right_ != nullptr) return std::nullopt;
        const auto vector = printed_vector(item->printed);
        if (vector && is_finite(*vector)) return Answer{*vector, is_right};
        if (!is_right || vector)
            note(item->spec, fmt::format("was printed as {}: not drawn.", shortened(item->printed)));
        return std::nullopt;
    }

    const ItemScore* find(const ItemId& id) const {
        for (const QuestionScore& each : score_.questions) {
            for (const ItemScore& item : each.items) {
                if (item.spec.id == id) return &item;
            }
        }
        return nullptr;
    }

    void note(const reference::ItemSpec& spec, const std::string& what) {
        result_.sketch.notes.push_back(fmt::format("{} {}", name_in_notes(spec), what));
    }

    /// Returns whether the point was near enough to be drawn.
    bool draw_point(const ItemId& id, const Answer& answer) {
        const reference::ItemSpec& spec = find(id)->spec;
        if (!frame_.holds(answer.value)) {
            note(spec, fmt::format("was printed as {}: beyond the frame.", shortened(find(id)->printed)));
            return false;
        }
        result_.sketch.dots.push_back({answer.value, "printed " + name_of(spec), Ink::printed, answer.mark()});
        return true;
    }

    void draw_vector(const ItemId& id, const Point& at, const Answer& answer) {
        constexpr double longest = 2;
        constexpr double shortest = 0.05;
        const reference::ItemSpec& spec = find(id)->spec;
        const double length = distance(answer.value, Point(0, 0, 0));
        if (!std::isfinite(length) || !(length > 0)) {
            note(spec, length > 0 ? "was printed with a length beyond all bounds: not drawn."
                                  : "was printed as the zero vector: not drawn.");
            return;
        }
        Point drawn = answer.value;
        if (length > longest || length < shortest) {
            drawn = drawn / length * (length > longest ? longest : 1.0);
            note(spec, fmt::format("was printed with length {:.3g}; only its direction is drawn.", length));
        }
        result_.sketch.arrows.push_back({at, drawn, "printed " + name_of(spec), Ink::printed, answer.stroke()});
    }

    void draw_P_VCS() {
        const auto P_VCS = answer(item::P_VCS);
        if (!P_VCS) return;
        result_.P_VCS = P_VCS->value;
        result_.P_VCS_name = name_in_notes(find(item::P_VCS)->spec);
        result_.is_P_VCS_right = P_VCS->is_right;
    }

    void draw_basis() {
        std::vector<Answer> axes;
        for (const ItemId& id : {item::X_vcs, item::Y_vcs, item::Z_vcs}) {
            const auto axis = answer(id);
            if (!axis) continue;
            draw_vector(id, scene_.camera.eye, *axis);
            axes.push_back(*axis);
        }
        if (right_ != nullptr || axes.size() != 3) return;
        // Draws the image plane as these axes put it, unless their lengths show that they are not axes.
        for (const Answer& axis : axes) {
            const double length = distance(axis.value, Point(0, 0, 0));
            constexpr double doubled = 2;
            if (!(length > 1 / doubled && length < doubled)) return;
        }
        const bool all_right = axes[0].is_right && axes[1].is_right && axes[2].is_right;
        const auto corners = window_corners(scene_, axes[0].value, axes[1].value, axes[2].value);
        const bool seen = std::any_of(corners.begin(), corners.end(), [&](const Point& p) { return frame_.holds(p); });
        result_.sketch.notes.emplace_back(seen ? "The image plane is drawn with the axes your program printed."
                                               : "The printed axes put the image plane beyond the frame.");
        result_.sketch.polygons.push_back({corners, Ink::printed, all_right ? Stroke::plain : Stroke::dashed});
    }

    void draw_ray() {
        const auto P_WCS = answer(item::P_WCS);
        const auto V = answer(item::V);
        const bool start_drawn = P_WCS && draw_point(item::P_WCS, *P_WCS);
        if (!V) return;
        std::optional<Point> start;
        if (start_drawn) start = P_WCS->value;
        if (!start && right_ != nullptr) start = right_->P_WCS;
        draw_vector(item::V, start.value_or(scene_.camera.eye), *V);
        const double length = distance(V->value, Point(0, 0, 0));
        if (!start || !(length > 0) || !std::isfinite(length)) return;
        Line ray = ray_from(*start, V->value / length, frame_);
        ray.ink = Ink::printed;
        ray.stroke = V->is_right && (!P_WCS || P_WCS->is_right) ? Stroke::thin : Stroke::dashed;
        result_.sketch.lines.push_back(ray);
    }

    /// The start of a printed normal: the printed hit point, else the right one.
    Point foot(const ItemId& hit_id, const std::optional<Point>& right_hit, const Point& otherwise) {
        const auto hit = answer(hit_id);
        if (hit && draw_point(hit_id, *hit)) return hit->value;
        if (right_ != nullptr && right_hit) return *right_hit;
        return otherwise;
    }

    /// The printed hit point and normal of the object that the questions are about.
    void draw_object(reference::Subject kind, const auto& objects) {
        if (objects.empty()) return;
        const RightHit right = right_ == nullptr ? RightHit() : right_->of(kind);
        const Point at = foot({kind, "hit"}, right.hit, middle_of(objects[right.index]));
        const ItemId normal_id{kind, "normal"};
        if (const auto normal = answer(normal_id)) draw_vector(normal_id, at, *normal);
    }

    const Score& score_;
    const DoubleScene& scene_;
    const RightValues* right_;
    const Frame& frame_;
    PrintedSketch result_;
};

}  // namespace

std::optional<Point> printed_vector(const std::string& printed) {
    std::vector<double> single;
    for (const Section& section : read_transcript("v = " + printed, 0).sections) {
        for (const PrintedValue& value : section.values) {
            const auto& numbers = value.numbers;
            if (numbers.size() == 3 || numbers.size() == 4)
                return Point(numbers[0].value, numbers[1].value, numbers[2].value);
            if (numbers.size() == 1) single.push_back(numbers[0].value);
        }
    }
    // One component per line; here they are joined.
    if (single.size() != 3 && single.size() != 4) return std::nullopt;
    return Point(single[0], single[1], single[2]);
}

PrintedSketch printed_sketch(const Score& score, const DoubleScene& scene, const RightValues* right,
                             const Frame& frame) {
    return PrintedDrawing(score, scene, right, frame).draw();
}

}  // namespace harness::report::picture
