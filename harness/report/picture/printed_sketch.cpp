#include "harness/report/picture/printed_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "harness/read/transcript.h"
#include "harness/report/picture/image_plane.h"

namespace harness::report::picture {
namespace {

namespace item = reference::item;
using reference::ItemId;

/// The name of an item in the picture.
std::string name_of(const reference::ItemSpec& spec) {
    if (spec.id.name == "hit") return std::string(spec.label);
    if (spec.id.name == "normal") return fmt::format("N_{}", to_string(spec.id.subject).front());  // as P_s is named
    return std::string(spec.id.name);
}

std::string shortened(const std::string& printed) {
    constexpr std::size_t longest = 48;
    return printed.size() <= longest ? printed : printed.substr(0, longest) + "...";
}

/// A printed point or vector that can be drawn.
struct Answer {
    const ItemScore* item = nullptr;
    Point value;

    bool is_right() const { return item->verdict == ItemVerdict::right; }
    Mark mark() const { return is_right() ? Mark::ring : Mark::cross; }
    Stroke stroke() const { return is_right() ? Stroke::plain : Stroke::dashed; }
    std::string name() const { return "printed " + name_of(item->spec); }
};

/// Draws one submission's answers; the sketch grows call by call.
class PrintedDrawing {
  public:
    PrintedDrawing(const Score& score, const DoubleScene& scene, const std::optional<RightValues>& right,
                   const Frame& frame, Sketch& sketch)
        : score_(score), scene_(scene), right_(right), frame_(frame), sketch_(sketch) {}

    void draw() {
        draw_pixel();
        draw_basis();
        draw_ray();
        reference::for_each_kind([&](reference::Subject kind, const auto& objects) { draw_object(kind, objects); },
                                 scene_);
    }

  private:
    /// Empty if the answer cannot be drawn, which is noted, or if it is right and not needed.
    std::optional<Answer> answer(const ItemId& id) {
        for (const QuestionScore& question : score_.questions) {
            for (const ItemScore& item : question.items) {
                if (item.spec.id == id) return answer(item);
            }
        }
        return std::nullopt;
    }

    std::optional<Answer> answer(const ItemScore& item) {
        const bool is_right = item.verdict == ItemVerdict::right;
        if (item.printed.empty() || (is_right && right_)) return std::nullopt;
        const auto vector = printed_vector(item.printed);
        if (vector && is_finite(*vector)) return Answer{&item, *vector};
        if (!is_right || vector)
            note(item, fmt::format("was printed as \"{}\", so it is not drawn.", shortened(item.printed)));
        return std::nullopt;
    }

    void note(const ItemScore& item, const std::string& sentence) {
        sketch_.notes.push_back(fmt::format("{} (question {}) {}", name_of(item.spec), item.spec.question, sentence));
    }

    /// Returns whether the point was near enough to be drawn.
    bool draw_point(const Answer& answer) {
        if (!frame_.holds(answer.value)) {
            note(*answer.item,
                 fmt::format("was printed as \"{}\", outside the picture.", shortened(answer.item->printed)));
            return false;
        }
        sketch_.dots.push_back({answer.value, answer.name(), Ink::printed, answer.mark()});
        return true;
    }

    void draw_vector(const Point& at, const Answer& answer) {
        constexpr double longest = 2;
        constexpr double shortest = 0.05;
        const double length = distance(answer.value, Point(0, 0, 0));
        if (!std::isfinite(length) || length == 0) {
            note(*answer.item, length > 0 ? "was printed with an enormous length, so it is not drawn."
                                          : "was printed as the zero vector, so it is not drawn.");
            return;
        }
        Point drawn = answer.value;
        if (length > longest || length < shortest) {
            drawn = drawn / length * (length > longest ? longest : 1.0);
            note(*answer.item, fmt::format("was printed with length {:.3g}; only its direction is drawn.", length));
        }
        sketch_.arrows.push_back({at, drawn, answer.name(), Ink::printed, answer.stroke()});
    }

    void draw_pixel() {
        const auto P_VCS = answer(item::P_VCS);
        if (!P_VCS) return;
        if (!is_in_window(scene_, P_VCS->value)) {
            note(*P_VCS->item, "was printed outside the image plane, so it is not drawn.");
            return;
        }
        if (P_VCS->value.z != -scene_.window.clip_near && !P_VCS->is_right())
            note(*P_VCS->item, "was printed with a z that is not the image plane's z.");
        sketch_.pixels.push_back({P_VCS->value, P_VCS->name(), Ink::printed, P_VCS->mark()});
    }

    /// If the right image plane is not drawn, also draws the one of the printed axes.
    void draw_basis() {
        std::vector<Answer> axes;
        for (const ItemId& id : {item::X_vcs, item::Y_vcs, item::Z_vcs}) {
            const auto axis = answer(id);
            if (!axis) continue;
            draw_vector(scene_.camera.eye, *axis);
            axes.push_back(*axis);
        }
        if (right_ || axes.size() != 3) return;
        const auto corners = window_corners(scene_, axes[0].value, axes[1].value, axes[2].value);
        const bool is_seen = std::ranges::any_of(corners, [&](const Point& corner) { return frame_.holds(corner); });
        sketch_.notes.emplace_back(is_seen ? "The image plane is drawn with the axes your program printed."
                                           : "The printed axes put the image plane outside the picture.");
        const bool all_right = std::ranges::all_of(axes, &Answer::is_right);
        sketch_.polygons.push_back({corners, Ink::printed, all_right ? Stroke::plain : Stroke::dashed});
    }

    void draw_ray() {
        const auto P_WCS = answer(item::P_WCS);
        const auto V = answer(item::V);
        std::optional<Point> start;
        if (P_WCS && draw_point(*P_WCS)) start = P_WCS->value;
        if (!V) return;
        if (!start && right_) start = right_->P_WCS;
        draw_vector(start.value_or(scene_.camera.eye), *V);
        const double length = distance(V->value, Point(0, 0, 0));
        if (!start || !(length > 0) || !std::isfinite(length)) return;
        Line ray = ray_from(*start, V->value / length, frame_);
        ray.ink = Ink::printed;
        ray.stroke = V->is_right() && (!P_WCS || P_WCS->is_right()) ? Stroke::thin : Stroke::dashed;
        sketch_.lines.push_back(ray);
    }

    /// The printed hit point and normal of the object that the questions are about. The normal starts at the printed
    /// point, else at the right one.
    void draw_object(reference::Subject kind, const auto& objects) {
        if (objects.empty()) return;
        const RightHit right = right_ ? right_->objects.at(kind) : RightHit();
        Point foot = right.hit.value_or(middle_of(objects[right.index]));
        const auto hit = answer(ItemId{kind, "hit"});
        if (hit && draw_point(*hit)) foot = hit->value;
        if (const auto normal = answer(ItemId{kind, "normal"})) draw_vector(foot, *normal);
    }

    const Score& score_;
    const DoubleScene& scene_;
    const std::optional<RightValues>& right_;
    const Frame& frame_;
    Sketch& sketch_;
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

bool draw_printed(const Score& score, const DoubleScene& scene, const std::optional<RightValues>& right,
                  const Frame& frame, Sketch& sketch) {
    const auto things = [&] { return sketch.pixels.size() + sketch.dots.size() + sketch.arrows.size(); };
    const std::size_t before = things();
    PrintedDrawing(score, scene, right, frame, sketch).draw();
    return things() > before;
}

}  // namespace harness::report::picture
