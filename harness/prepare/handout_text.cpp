#include "harness/prepare/handout_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace harness::prepare {
namespace {

using reference::Decimal;
using reference::ItemId;
namespace item = reference::item;

std::string point(const reference::Vec3<Decimal>& p) {
    return fmt::format("({} {} {})", p.x.text(), p.y.text(), p.z.text());
}

/// What the handout asks for, by item.
const std::map<ItemId, std::string_view>& wordings() {
    static const std::map<ItemId, std::string_view> words = {
        {item::P_VCS, "the pixel in view coordinates, P_VCS"},
        {item::X_vcs, "the basis vector X_vcs, unit length"},
        {item::Y_vcs, "the basis vector Y_vcs, unit length"},
        {item::Z_vcs, "the basis vector Z_vcs, unit length"},
        {item::M_VCS_to_WCS, "the matrix M_VCS_to_WCS, 4 x 4"},
        {item::P_WCS, "the pixel in world coordinates, P_WCS"},
        {item::V, "the unit vector V from the eye to the pixel; the ray is P = S + tV with S = P_WCS"},
        {item::sphere::a, "a of the quadratic a t^2 + b t + c = 0 for the sphere"},
        {item::sphere::b, "b of the sphere's quadratic"},
        {item::sphere::c, "c of the sphere's quadratic"},
        {item::sphere::d, "its discriminant d = b^2 - 4ac"},
        {item::sphere::t, "t of the hit on the sphere: positive, the smaller of two positive roots"},
        {item::sphere::hit, "the hit point P_s"},
        {item::sphere::normal, "the sphere's unit normal N at the hit point"},
        {item::triangle::matrix, "the 3 x 3 matrix of A + u(B-A) + v(C-A) = S + tV, columns t u v"},
        {item::triangle::rhs, "the right-hand side of that system"},
        {item::triangle::t, "t of the hit on the triangle"},
        {item::triangle::u, "u; a hit has 0 <= u <= 1, 0 <= v <= 1 and u + v <= 1"},
        {item::triangle::v, "v"},
        {item::triangle::hit, "the hit point P_t"},
        {item::triangle::normal, "the triangle's unit normal (B-A) x (C-A)"},
        {item::cylinder::a, "a of the quadratic for the cylinder's tube"},
        {item::cylinder::b, "b of the tube's quadratic"},
        {item::cylinder::c, "c of the tube's quadratic"},
        {item::cylinder::d, "its discriminant d = b^2 - 4ac"},
        {item::cylinder::t, "t of the hit on the cylinder: the smallest positive t of its tube and its two caps"},
        {item::cylinder::hit, "the hit point P_c"},
        {item::cylinder::normal, "the cylinder's unit normal N at the hit point, outward"},
        {item::first_object, "which object the ray hits first, as a sentence: \"ray hits ... first\""},
    };
    return words;
}

std::string sentence_about(const reference::Sphere<Decimal>& sphere) {
    return fmt::format("Sphere: center C {}, radius R {}.\n", point(sphere.center), sphere.radius.text());
}

std::string sentence_about(const reference::Triangle<Decimal>& triangle) {
    return fmt::format("Triangle: A {}, B {}, C {}.\n", point(triangle.A), point(triangle.B), point(triangle.C));
}

std::string sentence_about(const reference::Cylinder<Decimal>& cylinder) {
    return fmt::format(
        "Cylinder: axis parallel to the y axis, center {}, radius R {}, height {} from bottom to top, closed by two "
        "caps.\n",
        point(cylinder.center), cylinder.radius.text(), cylinder.height.text());
}

/// Where in its pixel the ray starts: what marking accepts.
std::string place_in_pixel(const std::vector<reference::PixelConvention>& accepted) {
    const auto share = [](reference::PixelConvention convention) {
        switch (convention) {
            case reference::PixelConvention::centre: return "(x + 1/2)/W";
            case reference::PixelConvention::grid: return "x/(W - 1)";
            case reference::PixelConvention::corner: return "x/W";
        }
        return "";
    };
    std::vector<std::string_view> shares;
    for (const reference::PixelConvention pixel_convention : accepted) shares.emplace_back(share(pixel_convention));
    return fmt::format(
        "The ray starts in it at {} of the window's width from the left, and likewise from the bottom.\n",
        fmt::join(shares, " or "));
}

std::string scene_text(const reference::Scene<Decimal>& scene, const reference::Rubric& rubric) {
    std::string text = fmt::format("Camera: eye {}, lookat {}, vup {}.\n", point(scene.camera.eye),
                                   point(scene.camera.lookat), point(scene.camera.vup));
    const auto& window = scene.window;
    text += fmt::format(
        "Window: left {}, right {}, bottom {}, top {}, near {}; width W = {}, height H = {} pixels; pixel ({} {}), x "
        "from the left, y from the bottom, both from 0.\n",
        window.clip_left.text(), window.clip_right.text(), window.clip_bottom.text(), window.clip_top.text(),
        window.clip_near.text(), window.width, window.height, scene.pixel.x, scene.pixel.y);
    text += place_in_pixel(rubric.pixel_conventions);
    reference::for_each_kind(
        [&](reference::Subject /*kind*/, const auto& objects) {
            for (const auto& object : objects) text += sentence_about(object);
        },
        scene);
    return text;
}

std::string list_of(const std::vector<ItemId>& items, std::string_view indent) {
    std::string text;
    for (const ItemId& id : items) text += fmt::format("{}- {}\n", indent, wordings().at(id));
    return text;
}

std::string points_text(double points) {
    return fmt::format("({:g} point{})", points, points == 1 ? "" : "s");
}

/// "a) the quadratic (6 points)" and its items, for each part; points only where parts have their own.
std::string parts_text(const reference::Question& question, const reference::Rubric& rubric) {
    const auto points = rubric.item_points.find(question.number);
    const std::vector<reference::ItemSpec> specs = reference::asked_items({question});
    auto spec = specs.begin();
    std::string text;
    char letter = 'a';
    for (const reference::QuestionPart& part : question.parts) {
        double sum = 0;
        for (std::size_t i = 0; i < part.items.size(); ++i, ++spec) {
            if (points == rubric.item_points.end()) continue;
            const auto own = points->second.find(std::string(spec->name));
            if (own != points->second.end()) sum += own->second;
        }
        text += fmt::format("   {}){}{}{}\n{}", letter++, part.title.empty() ? "" : " ", part.title,
                            points == rubric.item_points.end() ? "" : " " + points_text(sum),
                            list_of(part.items, "      "));
    }
    return text;
}

}  // namespace

std::string handout_text(const reference::Assignment& assignment) {
    std::string text =
        fmt::format("# {}\n\n## The scene\n\n{}\n", assignment.title, scene_text(assignment.scene, assignment.rubric));
    text += fmt::format(
        "## Questions\n\nHand in one C++ source, `ray_cast.cpp`. It uses GLM and prints to `std::cout`: each answer "
        "with a label, under the heading \"Question N\", with a decimal point and at least {} decimals; \"no hit\" for "
        "what is not there because the ray misses.\n",
        std::max(assignment.rubric.min_decimals, 2));
    for (const reference::Question& question : assignment.questions) {
        text += fmt::format("\n{}. **{}** {}\n", question.number, question.title,
                            points_text(assignment.rubric.points_of(question.number)));
        text += question.parts.empty() ? list_of(question.items, "   ") : parts_text(question, assignment.rubric);
    }
    return text;
}

}  // namespace harness::prepare
