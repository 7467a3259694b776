// Correct float programs' answers for a cylinder lie within the allowances, whatever their formulas; mistakes do not.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "reference/key/answer_key.h"
#include "tests/given/cases.h"
#include "tests/given/random_scene.h"
#include "tests/given/student/scenes.h"

namespace {

using namespace reference;

const Answer& answer_to(const AnswerKey& key, const ItemId& id) {
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            if (item.spec.id == id) return item.answers.front();
        }
    }
    throw std::out_of_range(std::string(id.name));
}

bool is_allowed(const Answer& key, const std::vector<float>& given) {
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto x = static_cast<double>(given[i]);
        if (!(key.lo[i] - key.allowance[i] <= x && x <= key.hi[i] + key.allowance[i])) return false;
    }
    return true;
}

std::vector<float> numbers_of(const glm::vec3& p) {
    return {p.x, p.y, p.z};
}

struct FloatRay {
    glm::vec3 S;
    glm::vec3 V;
};

/// By lookAt and its inverse, or from the camera's axes.
FloatRay ray_of(const Scene<float>& scene, bool by_look_at) {
    const auto& window = scene.window;
    const float dx = (window.clip_right - window.clip_left) / static_cast<float>(window.width);
    const float dy = (window.clip_top - window.clip_bottom) / static_cast<float>(window.height);
    const glm::vec3 P_VCS(window.clip_left + (static_cast<float>(scene.pixel.x) + 0.5F) * dx,
                          window.clip_bottom + (static_cast<float>(scene.pixel.y) + 0.5F) * dy, -window.clip_near);
    const glm::vec3 eye(scene.camera.eye), lookat(scene.camera.lookat), vup(scene.camera.vup);
    if (by_look_at) {
        const glm::vec3 S(glm::inverse(glm::lookAt(eye, lookat, vup)) * glm::vec4(P_VCS, 1));
        return {S, glm::normalize(S - eye)};
    }
    const glm::vec3 Z = glm::normalize(eye - lookat);
    const glm::vec3 X = glm::normalize(glm::cross(vup, Z));
    const glm::vec3 to_pixel = P_VCS.x * X + P_VCS.y * glm::cross(Z, X) + P_VCS.z * Z;
    return {eye + to_pixel, glm::normalize(to_pixel)};
}

enum class Root { textbook, half_b, quotients, without_cancellation, by_distance, ways };

/// The root of sign -1 or 1.
float root_of(Root way, float a, float b, float c, float beside, float R, float sign) {
    const float spread = sign * std::sqrt(b * b - 4 * a * c);
    switch (way) {
        case Root::textbook: return (-b + spread) / (2 * a);
        case Root::half_b: return (-b / 2 + sign * std::sqrt(b / 2 * (b / 2) - a * c)) / a;
        case Root::quotients: return -b / (2 * a) + spread / (2 * a);
        case Root::without_cancellation: return b * sign > 0 ? 2 * c / (-b - spread) : (-b + spread) / (2 * a);
        case Root::by_distance: return (-b / 2 + sign * std::sqrt(a * R * R - beside * beside)) / a;
        case Root::ways: break;
    }
    return 0;
}

/// What a program answers that decides as the key does.
std::map<ItemId, std::vector<float>> program_answers(const Scene<float>& scene, const AnswerKey& key, int way) {
    const auto [S, V] = ray_of(scene, way % 2 == 0);
    const glm::vec3 center(scene.cylinders[0].center);
    const float R = scene.cylinders[0].radius, half = scene.cylinders[0].height / 2;
    const float x = S.x - center.x, z = S.z - center.z;
    const float a = V.x * V.x + V.z * V.z;
    const float b = 2 * x * V.x + 2 * z * V.z;
    const float c = way % 3 == 0   ? x * x + z * z - R * R
                    : way % 3 == 1 ? S.x * S.x - 2 * S.x * center.x + center.x * center.x + S.z * S.z -
                                         2 * S.z * center.z + center.z * center.z - R * R
                                   : glm::dot(glm::vec2(S.x, S.z), glm::vec2(S.x, S.z)) -
                                         2 * glm::dot(glm::vec2(S.x, S.z), glm::vec2(center.x, center.z)) +
                                         glm::dot(glm::vec2(center.x, center.z), glm::vec2(center.x, center.z)) - R * R;
    std::map<ItemId, std::vector<float>> answers{{item::cylinder::a, {a}},
                                                 {item::cylinder::b, {b}},
                                                 {item::cylinder::c, {c}},
                                                 {item::cylinder::d, {b * b - 4 * a * c}}};
    const auto* normal = std::get_if<Numbers>(&answer_to(key, item::cylinder::normal).value);
    if (normal == nullptr) return answers;
    const bool from_inside = std::get<Numbers>(answer_to(key, item::cylinder::c).value).front() < 0;
    const bool on_tube = (*normal)[1] == 0;
    const float up = static_cast<float>((*normal)[1]);
    const float t = on_tube ? root_of(static_cast<Root>(way % static_cast<int>(Root::ways)), a, b, c, x * V.z - z * V.x,
                                      R, from_inside ? 1.0F : -1.0F)
                            : (center.y + up * half - S.y) / V.y;
    const glm::vec3 hit = S + t * V;
    const glm::vec3 outward(hit.x - center.x, 0, hit.z - center.z);
    answers[item::cylinder::t] = {t};
    answers[item::cylinder::hit] = numbers_of(hit);
    answers[item::cylinder::normal] = numbers_of(!on_tube      ? glm::vec3(0, up, 0)
                                                 : way % 4 < 2 ? glm::normalize(outward)
                                                               : outward / R);
    return answers;
}

/// p moved by some hundreds: the squares of its coordinates are large beside the cylinder's then.
Vec3<Decimal> moved(const Vec3<Decimal>& p) {
    const auto sum = [](const Decimal& x, double y) {
        return *Decimal::parse(fmt::format("{:.3f}", x.to_double() + y));
    };
    return {sum(p.x, 300), sum(p.y, -200), sum(p.z, 100)};
}

/// Every second scene is near the origin.
Assignment scene_with_cylinder(std::uint64_t seed) {
    Assignment assignment = random_assignment_with_cylinder(seed);
    Scene<Decimal>& scene = assignment.scene;
    if (seed % 2 == 1) {
        for (Vec3<Decimal>* p : {&scene.camera.eye, &scene.camera.lookat, &scene.cylinders[0].center}) *p = moved(*p);
    }
    assignment.rubric.pixel_conventions = {PixelConvention::centre};
    assignment.rubric.boundary = BoundaryPolicy::nonnegative;
    return assignment;
}

TEST(CylinderAllowance, CoversFloatProgramsOfManyFormulas) {
    // Fewer might hold no ray that hits a cap.
    const std::uint64_t scenes = std::max<std::uint64_t>(cases(30), 20);
    std::uint64_t tubes = 0, caps = 0;
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        SCOPED_TRACE(seed);
        const Assignment assignment = scene_with_cylinder(seed);
        const AnswerKey key = make_key(assignment, Precision::certified);
        const Scene<float> scene =
            convert_scene<float>(assignment.scene, [](const Decimal& x) { return x.to_float(); });
        const auto* normal = std::get_if<Numbers>(&answer_to(key, item::cylinder::normal).value);
        if (normal != nullptr) ++((*normal)[1] == 0 ? tubes : caps);
        for (int way = 0; way < 60; ++way) {
            for (const auto& [id, given] : program_answers(scene, key, way))
                EXPECT_TRUE(is_allowed(answer_to(key, id), given)) << id.name << ", way " << way;
        }
    }
    EXPECT_GT(tubes, scenes / 10);
    EXPECT_GT(caps, scenes / 20);
}

TEST(CylinderAllowance, CoversTheStagesInFloatAndInDouble) {
    std::uint64_t compared = 0;
    for (std::uint64_t seed = 0; seed < cases(30); ++seed) {
        SCOPED_TRACE(seed);
        const Assignment assignment = scene_with_cylinder(seed);
        const AnswerKey key = make_key(assignment, Precision::certified);
        for (const Precision precision : {Precision::float_, Precision::double_}) {
            const AnswerKey run = make_key(assignment, precision);
            EXPECT_EQ(run.decisions.of(reference::Subject::cylinder), key.decisions.of(reference::Subject::cylinder));
            for (const Item& item : known_items()) {
                const Answer& certified = answer_to(key, item.id);
                const auto* given = std::get_if<Numbers>(&answer_to(run, item.id).value);
                if (given == nullptr || !std::holds_alternative<Numbers>(certified.value)) continue;
                ++compared;
                EXPECT_TRUE(is_allowed(certified, std::vector<float>(given->begin(), given->end()))) << item.full_name;
            }
        }
    }
    EXPECT_GT(compared, 30 * cases(30));
}

TEST(CylinderAllowance, IsTooSmallForUsualMistakes) {
    std::uint64_t hits = 0;
    for (std::uint64_t seed = 0; seed < cases(30); ++seed) {
        const Assignment assignment = scene_with_cylinder(seed);
        const AnswerKey key = make_key(assignment, Precision::certified);
        const Answer& normal = answer_to(key, item::cylinder::normal);
        const auto* hit = std::get_if<Numbers>(&answer_to(key, item::cylinder::hit).value);
        if (hit == nullptr || std::get<Numbers>(normal.value)[1] != 0) continue;
        ++hits;
        const glm::vec3 P((*hit)[0], (*hit)[1], (*hit)[2]);
        EXPECT_FALSE(is_allowed(normal, numbers_of(glm::normalize(glm::vec3(P.x, 0, P.z)))))
            << "the center is forgotten";
        const glm::vec3 center(
            convert_scene<float>(assignment.scene, [](const Decimal& x) { return x.to_float(); }).cylinders[0].center);
        EXPECT_FALSE(is_allowed(normal, numbers_of(glm::normalize(P - center)))) << "y is not left out";
    }
    EXPECT_GT(hits, cases(30) / 10);
}

TEST(WideAllowances, NameACylindersReason) {
    const auto notes = [](const std::string& cylinder) {
        return make_key(parse_assignment(student::camera_on_the_axis(4) + "[[cylinder]]\n" + cylinder +
                                             "\n[[question]]\nitems = [\"cylinder.d\", \"cylinder.t\"]\n",
                                         "scene.toml"),
                        Precision::certified)
            .notes;
    };
    EXPECT_THAT(notes("center = [0.3, 0, 0.1]\nradius = 1.1\nheight = 2"), testing::IsEmpty());
    EXPECT_THAT(
        notes("center = [1.1, 0.1, 0.3]\nradius = 1.1000001\nheight = 2"),
        testing::ElementsAre(testing::AllOf(testing::StartsWith("Float is inaccurate for the cylinder of this scene."),
                                            testing::HasSubstr("the ray almost touches the cylinder's tube"))));
    EXPECT_THAT(notes("center = [0.3, 0.2, -300.3]\nradius = 1.1\nheight = 2"),
                testing::ElementsAre(testing::HasSubstr("the cylinder is thin compared with its distance")));
}

}  // namespace
