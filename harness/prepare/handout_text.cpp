#include "harness/prepare/handout_text.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string_view>

namespace harness::prepare {
namespace {

using reference::Decimal;
using reference::ItemId;
using Kind = Block::Kind;
namespace item = reference::item;

std::string point(const reference::Vec3<Decimal>& p) {
    return fmt::format("({}, {}, {})", p.x.text(), p.y.text(), p.z.text());
}

/// The handout's words for each item.
const std::map<ItemId, std::string_view>& wordings() {
    static const std::map<ItemId, std::string_view> words = {
        {item::P_VCS, "P_VCS: the pixel in view coordinates"},
        {item::X_vcs, "X_vcs: the unit vector along the x axis of view coordinates"},
        {item::Y_vcs, "Y_vcs: the unit vector along the y axis of view coordinates"},
        {item::Z_vcs, "Z_vcs: the unit vector along the z axis of view coordinates"},
        {item::M_VCS_to_WCS, "M_VCS_to_WCS: the 4 × 4 matrix from view coordinates to world coordinates"},
        {item::P_WCS, "P_WCS: the pixel in world coordinates"},
        {item::V, "V: the unit vector from the eye to the pixel. The ray is P = S + tV with S = P_WCS."},
        {item::sphere::a, "a: the coefficient of t² in the sphere's quadratic, a t² + b t + c = 0"},
        {item::sphere::b, "b: the coefficient of t in the sphere's quadratic"},
        {item::sphere::c, "c: the constant term of the sphere's quadratic"},
        {item::sphere::d, "d: the discriminant of the sphere's quadratic, b² − 4ac"},
        {item::sphere::t, "t: where the ray hits the sphere. If both roots are positive, it is the smaller one."},
        {item::sphere::hit, "P_s: the point where the ray hits the sphere"},
        {item::sphere::normal, "N: the unit normal of the sphere at P_s"},
        {item::triangle::matrix,
         "Matrix: the 3 × 3 matrix of the linear system A + u(B − A) + v(C − A) = S + tV, columns t, u, v"},
        {item::triangle::rhs, "Right-hand side: the vector of the triangle's linear system"},
        {item::triangle::t, "t: where the ray meets the plane of the triangle"},
        {item::triangle::u,
         "u: the coordinate along B − A. The ray hits the triangle if 0 ≤ u ≤ 1, 0 ≤ v ≤ 1 and u + v ≤ 1."},
        {item::triangle::v, "v: the coordinate along C − A"},
        {item::triangle::hit, "P_t: the point where the ray hits the triangle"},
        {item::triangle::normal, "N: the unit normal of the triangle, along (B − A) × (C − A)"},
        {item::cylinder::a, "a: the coefficient of t² in the quadratic of the cylinder's tube, a t² + b t + c = 0"},
        {item::cylinder::b, "b: the coefficient of t in the tube's quadratic"},
        {item::cylinder::c, "c: the constant term of the tube's quadratic"},
        {item::cylinder::d, "d: the discriminant of the tube's quadratic, b² − 4ac"},
        {item::cylinder::t, "t: where the ray hits the cylinder, the smallest positive t of its tube and its two caps"},
        {item::cylinder::hit, "P_c: the point where the ray hits the cylinder"},
        {item::cylinder::normal, "N: the unit normal of the cylinder at P_c, pointing outward"},
        {item::first_object, "Which object the ray hits first, as a sentence: \"ray hits … first\""},
    };
    return words;
}

Block fact_about(const reference::Sphere<Decimal>& sphere) {
    return {Kind::fact, fmt::format("center C {}, radius R {}", point(sphere.center), sphere.radius.text()), "Sphere"};
}

Block fact_about(const reference::Triangle<Decimal>& triangle) {
    return {Kind::fact, fmt::format("A {}, B {}, C {}", point(triangle.A), point(triangle.B), point(triangle.C)),
            "Triangle"};
}

Block fact_about(const reference::Cylinder<Decimal>& cylinder) {
    return {Kind::fact,
            fmt::format("center {}, radius R {}, height {}. Its axis is parallel to the y axis, and two caps close it.",
                        point(cylinder.center), cylinder.radius.text(), cylinder.height.text()),
            "Cylinder"};
}

/// The positions in the pixel that marking accepts, as a share of the window's width or height.
std::string shares(const std::vector<reference::PixelConvention>& accepted, char pixel, char count) {
    const auto share = [&](reference::PixelConvention convention) {
        switch (convention) {
            case reference::PixelConvention::centre: return fmt::format("({}+1/2)/{}", pixel, count);
            case reference::PixelConvention::grid: return fmt::format("{}/({}−1)", pixel, count);
            case reference::PixelConvention::corner: return fmt::format("{}/{}", pixel, count);
        }
        return std::string();
    };
    std::vector<std::string> list;
    for (const reference::PixelConvention convention : accepted) list.push_back(share(convention));
    return fmt::format("{}", fmt::join(list, " or "));
}

void add_scene(std::vector<Block>& text, const reference::Scene<Decimal>& scene, const reference::Rubric& rubric) {
    text.push_back({Kind::fact,
                    fmt::format("eye {}, lookat {}, vup {}", point(scene.camera.eye), point(scene.camera.lookat),
                                point(scene.camera.vup)),
                    "Camera"});
    const auto& window = scene.window;
    text.push_back({Kind::fact,
                    fmt::format("left {}, right {}, bottom {}, top {}, near {}; {} pixels wide (W) and {} high (H)",
                                window.clip_left.text(), window.clip_right.text(), window.clip_bottom.text(),
                                window.clip_top.text(), window.clip_near.text(), window.width, window.height),
                    "Window"});
    text.push_back({Kind::fact,
                    fmt::format("(x, y) = ({}, {}), counted from 0 at the lower left. The ray passes through the "
                                "window at {} of its width from the left and {} of its height from the bottom.",
                                scene.pixel.x, scene.pixel.y, shares(rubric.pixel_conventions, 'x', 'W'),
                                shares(rubric.pixel_conventions, 'y', 'H')),
                    "Pixel"});
    reference::for_each_kind(
        [&](reference::Subject /*kind*/, const auto& objects) {
            for (const auto& object : objects) text.push_back(fact_about(object));
        },
        scene);
}

std::string points_text(double points) {
    return fmt::format("{:g} point{}", points, points == 1 ? "" : "s");
}

void add_items(std::vector<Block>& text, const std::vector<ItemId>& items) {
    for (const ItemId& id : items) text.push_back({Kind::item, std::string(wordings().at(id))});
}

/// "a) the quadratic (6 points)" and its items, for each part. Points only if the parts have their own.
void add_parts(std::vector<Block>& text, const reference::Question& question, const reference::Rubric& rubric) {
    const auto points = rubric.item_points.find(question.number);
    const std::vector<reference::ItemSpec> specs = reference::asked_items({question});
    auto spec = specs.begin();
    char letter = 'a';
    for (const reference::QuestionPart& part : question.parts) {
        double sum = 0;
        for (std::size_t i = 0; i < part.items.size(); ++i, ++spec) {
            if (points == rubric.item_points.end()) continue;
            const auto own = points->second.find(std::string(spec->name));
            if (own != points->second.end()) sum += own->second;
        }
        text.push_back({Kind::part,
                        fmt::format("{}){}{}{}", letter++, part.title.empty() ? "" : " ", part.title,
                                    points == rubric.item_points.end() ? "" : fmt::format(" ({})", points_text(sum)))});
        add_items(text, part.items);
    }
}

/// "Thursday, November 5, 2026, 23:59 (UTC+01:00)"
std::string date_text(const reference::Moment& moment) {
    const std::tm local = fmt::gmtime(static_cast<std::time_t>((moment.minutes + moment.offset) * 60));
    std::string text = fmt::format("{0:%A, %B} {1}, {0:%Y, %H:%M}", local, local.tm_mday);
    if (!moment.has_zone) return text;
    const std::int64_t ahead = std::abs(moment.offset);
    const std::string offset =
        ahead == 0 ? "" : fmt::format("{}{:02}:{:02}", moment.offset < 0 ? '-' : '+', ahead / 60, ahead % 60);
    return text + fmt::format(" (UTC{})", offset);
}

}  // namespace

std::vector<Block> handout_text(const reference::Assignment& assignment, const std::string& student) {
    const reference::Rubric& rubric = assignment.rubric;
    double points = 0;
    for (const reference::Question& question : assignment.questions) points += rubric.points_of(question.number);
    std::vector<Block> text{{Kind::title, assignment.title}};
    if (!student.empty()) text.push_back({Kind::fact, student, "Name"});
    if (rubric.due) text.push_back({Kind::fact, date_text(*rubric.due), "Due"});
    std::string all_points = fmt::format("{:g}", points);
    if (rubric.variant_points > 0)
        all_points += fmt::format(", and {:g} more for right answers on other scenes", rubric.variant_points);
    text.push_back({Kind::fact, all_points, "Points"});
    text.push_back({Kind::paragraph,
                    fmt::format("Write a C++ program that casts the ray through one pixel of the scene below. It "
                                "computes the answers to all questions and prints them to std::cout. Submit one source "
                                "file, ray_cast.cpp; it may use GLM. Begin each question with a line \"Question 1:\", "
                                "and write each answer after its name. Use a decimal point and at least {} decimals. "
                                "If the ray misses an object, print \"no hit\" for the answers that do not exist.",
                                std::max(rubric.min_decimals, 2))});
    text.push_back({Kind::heading, "Scene"});
    text.push_back({Kind::picture, "The scene"});
    add_scene(text, assignment.scene, rubric);
    text.push_back({Kind::heading, "Questions"});
    for (const reference::Question& question : assignment.questions) {
        text.push_back({Kind::question, fmt::format("{}. {} ({})", question.number, question.title,
                                                    points_text(rubric.points_of(question.number)))});
        if (question.parts.empty()) {
            add_items(text, question.items);
        } else {
            add_parts(text, question, rubric);
        }
    }
    return text;
}

}  // namespace harness::prepare
