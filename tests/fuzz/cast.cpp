#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reference/cast/queries.h"
#include "reference/cast/scene_queries.h"
#include "reference/kernel/first.h"
#include "reference/toml/assignment.h"
#include "tests/fuzz/properties.h"

namespace {

using reference::cast::answer_lines;
using reference::cast::answer_records;
using reference::cast::first_hit;
using reference::cast::FirstHit;
using reference::render::PreparedScene;
using Kind = FirstHit::Kind;

/// A step pyramid of triangles that share edges, a ball on it and a column through it.
const PreparedScene& scene_to_cast_at() {
    static const PreparedScene prepared = [] {
        std::string toml =
            "[camera]\neye = [0, 0, 4]\nlookat = [0, 0, 0]\nvup = [0, 1, 0]\n[window]\nclip_left = -1\nclip_right = 1\n"
            "clip_bottom = -1\nclip_top = 1\nclip_near = 1\nwidth = 2\nheight = 2\npixel = [0, 0]\n"
            "[[sphere]]\ncenter = [0, 0, 1]\nradius = 1\n[[cylinder]]\ncenter = [2, 0, 0]\nradius = 0.5\nheight = 3\n";
        const auto corner = [](int x, int y) {
            return "[" + std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(-std::abs(x - y)) + "]";
        };
        for (int x = -2; x < 2; ++x) {
            for (int y = -2; y < 2; ++y) {
                for (const auto& [a, b] : {std::pair(1, 0), std::pair(0, 1)}) {
                    toml += "[[triangle]]\nvertices = [" + corner(x, y) + "," + corner(x + 1, y + 1) + "," +
                            corner(x + a, y + b) + "]\n";
                }
            }
        }
        return reference::cast::objects_of(reference::parse_assignment(toml, "scene.toml"));
    }();
    return prepared;
}

/// What trying each object gives.
const char* wrong_with(const FirstHit& hit, const reference::kernel::Ray<double>& ray) {
    static reference::kernel::Objects objects;
    if (objects.spheres.empty()) {
        objects.spheres = scene_to_cast_at().spheres;
        objects.cylinders = scene_to_cast_at().cylinders;
        for (const auto& triangle : scene_to_cast_at().triangles) objects.triangles.push_back(triangle.triangle);
    }
    reference::kernel::Cast all;
    cast_ray(ray, objects, all);
    const std::optional<reference::FirstObject>& first = all.first.object;
    if (first == reference::FirstObject::tie) return hit.is_tie ? nullptr : "a tie is not told";
    if (hit.is_tie) return "a tie that is none";
    const auto is = [&](reference::Subject object) { return first && first->kind() == object; };
    const auto kind = !first                             ? Kind::invalid
                      : is(reference::Subject::sphere)   ? Kind::sphere
                      : is(reference::Subject::triangle) ? Kind::triangle
                      : is(reference::Subject::cylinder) ? Kind::cylinder
                                                         : Kind::none;
    return hit.kind == kind && hit.index == all.first.index ? nullptr : "trying each object finds a different one";
}

std::string check_lines(std::string_view lines, const auto& answer) {
    std::istringstream in{std::string(lines)};
    std::ostringstream out;
    const long malformed = answer(in, out, 1);
    std::istringstream again{std::string(lines)};
    std::ostringstream by_two;
    answer(again, by_two, 2);
    if (out.str() != by_two.str()) return "two threads answer lines otherwise";
    long number = 0;
    long errors = 0;
    std::istringstream answers(out.str());
    for (std::string text; std::getline(answers, text);) {
        ++number;
        const auto json = nlohmann::json::parse(text, nullptr, false);
        if (!json.is_object()) return "an answer is no JSON object: " + text;
        if (!json.contains("error")) continue;
        ++errors;
        if (json.at("line") != number) return "an error names a different line: " + text;
    }
    if (errors != malformed) return "the malformed lines are counted otherwise";
    const auto ends = std::count(lines.begin(), lines.end(), '\n');
    const bool has_rest = !lines.empty() && lines.back() != '\n';
    return number == ends + (has_rest ? 1 : 0) ? "" : "there is not an answer for each line";
}

double double_at(std::string_view bytes, std::size_t at) {
    std::uint64_t x = 0;
    for (std::size_t i = 8; i-- > 0;) x = x << 8U | static_cast<unsigned char>(bytes[at + i]);
    return std::bit_cast<double>(x);
}

std::string check_records(std::string_view records) {
    std::istringstream in{std::string(records)};
    std::ostringstream out;
    const auto read = answer_records(scene_to_cast_at(), in, out, 1);
    std::istringstream again{std::string(records)};
    std::ostringstream by_two;
    answer_records(scene_to_cast_at(), again, by_two, 2);
    if (out.str() != by_two.str()) return "two threads answer records otherwise";
    using reference::cast::answer_bytes;
    using reference::cast::ray_bytes;
    if (read.whole != records.size() / ray_bytes || read.left_over != records.size() % ray_bytes ||
        out.str().size() != read.whole * answer_bytes) {
        return "records are counted otherwise";
    }
    constexpr double most = 1 + 0x1p-52;
    for (std::size_t i = 0; i < read.whole; ++i) {
        const std::string_view record = records.substr(i * ray_bytes, ray_bytes);
        const auto point = [&](std::size_t at) {
            return reference::Vec3<double>(double_at(record, at), double_at(record, at + 8),
                                           double_at(record, at + 16));
        };
        const FirstHit hit = first_hit(scene_to_cast_at(), {point(0), point(24)});
        if (!(hit.t >= 0 && hit.u >= 0 && hit.u <= most && hit.v >= 0 && hit.v <= most)) return "a hit that is nowhere";
        if (const char* const wrong = wrong_with(hit, {point(0), point(24)})) return wrong;
    }
    return "";
}

}  // namespace

std::string check_cast(std::string_view bytes) {
    const auto own_objects = [](auto& in, auto& out, int jobs) {
        return reference::cast::answer_queries(in, out, jobs);
    };
    const auto to_scene = [](auto& in, auto& out, int jobs) { return answer_lines(scene_to_cast_at(), in, out, jobs); };
    if (std::string broken = check_lines(bytes, own_objects); !broken.empty()) return broken;
    if (std::string broken = check_lines(bytes, to_scene); !broken.empty()) return broken;
    return check_records(bytes);
}
