#include "harness/source/scene/scene_part.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

namespace harness::source {
namespace {

using reference::Decimal;
using reference::Vec3;

using reference::Pixel;
using reference::Subject;

/// Calls visit(places...) with a part's place in each of the given objects, field by field.
template <class Visit>
class PlaceVisitor {
  public:
    PlaceVisitor(std::size_t place, const Visit& visit) : left_(place), visit_(visit) {}

    template <class... Points>
    void operator()(std::string_view /*name*/, const reference::Vertices<Points>&... vertices) {
        for (std::size_t i = 0; i < std::size(std::get<0>(std::tie(vertices...))); ++i) take(*vertices[i]...);
    }
    template <class... Fields>
    void operator()(std::string_view /*name*/, Fields&... fields) {
        take(fields...);
    }

  private:
    template <class... Places>
    void take(Places&... places) {
        if (left_-- == 0) visit_(places...);
    }

    std::size_t left_;  ///< the largest number, once the place was visited
    const Visit& visit_;
};

/// Calls visit(place) with the part's place in each of the scenes: a vector, a number or the pixel.
template <class Visit, class... Scenes>
void visit_part(ScenePart part, const Visit& visit, Scenes&... scenes) {
    if (part == part::eye) return visit(scenes.camera.eye...);
    if (part == part::lookat) return visit(scenes.camera.lookat...);
    if (part == part::vup) return visit(scenes.camera.vup...);
    if (part == part::pixel) return visit(scenes.pixel...);
    reference::for_each_kind(
        [&](Subject kind, auto&... objects) {
            if (kind != part.subject) return;
            PlaceVisitor<Visit> visitor(part.place, visit);
            const auto on_field = [&](std::string_view name, auto&&... fields) {
                visitor(name, std::forward<decltype(fields)>(fields)...);
            };
            reference::for_each_field(on_field, objects.front()...);
        },
        scenes...);
}

std::vector<double> numbers_of(const Vec3<Decimal>& p) {
    return {p.x.to_double(), p.y.to_double(), p.z.to_double()};
}
std::vector<double> numbers_of(const Decimal& x) {
    return {x.to_double()};
}
std::vector<double> numbers_of(const Pixel& pixel) {
    return {static_cast<double>(pixel.x), static_cast<double>(pixel.y)};
}

struct Writer {
    const std::array<Decimal, 3>& numbers;
    void operator()(Vec3<Decimal>& p) const { p = {numbers[0], numbers[1], numbers[2]}; }
    void operator()(Decimal& x) const { x = numbers[0]; }
    void operator()(Pixel& pixel) const {
        pixel = {static_cast<int>(numbers[0].to_double()), static_cast<int>(numbers[1].to_double())};
    }
};

const DecimalScene& with_one_of_each() {
    static const DecimalScene scene = [] {
        DecimalScene decimal_scene{};
        reference::for_each_kind([](Subject /*kind*/, auto& objects) { objects.resize(1); }, decimal_scene);
        return decimal_scene;
    }();
    return scene;
}

}  // namespace

const std::vector<ScenePart>& all_parts() {
    static const std::vector<ScenePart> parts = [] {
        std::vector<ScenePart> all{part::eye, part::lookat, part::vup};
        for (const Subject object : reference::objects) {
            const std::vector<ScenePart>& more = parts_of(object);
            all.insert(all.end(), more.begin(), more.end());
        }
        all.push_back(part::pixel);
        return all;
    }();
    return parts;
}

const std::vector<ScenePart>& parts_of(Subject object) {
    static const std::map<Subject, std::vector<ScenePart>> parts = [] {
        std::map<Subject, std::vector<ScenePart>> all;
        for (const Subject subject : reference::objects) {
            for (ScenePart next{subject, 0}; size_of(next) > 0; ++next.place) all[subject].push_back(next);
        }
        return all;
    }();
    return parts.at(object);
}

std::vector<ScenePart> numbers_behind(ScenePart point) {
    if (point.subject == Subject::camera || point.place > 0) return {};
    const std::vector<ScenePart>& parts = parts_of(point.subject);
    std::vector<ScenePart> behind(parts.begin() + 1, parts.end());
    const auto is_number = [](ScenePart part) { return size_of(part) == 1; };
    return std::ranges::all_of(behind, is_number) ? behind : std::vector<ScenePart>();
}

std::size_t size_of(ScenePart part) {
    std::size_t size = 0;
    visit_part(
        part, [&](const auto& place) { size = numbers_of(place).size(); }, with_one_of_each());
    return size;
}

std::array<double, 3> value_of(const DecimalScene& scene, ScenePart part) {
    std::array<double, 3> value{};
    visit_part(
        part, [&](const auto& place) { std::ranges::copy(numbers_of(place), value.begin()); }, scene);
    return value;
}

void copy_part(DecimalScene& to, const DecimalScene& from, ScenePart part) {
    visit_part(
        part, [](auto& place, const auto& value) { place = value; }, to, from);
}

void set_part(DecimalScene& scene, ScenePart part, const std::array<Decimal, 3>& numbers) {
    visit_part(part, Writer{numbers}, scene);
}

}  // namespace harness::source
