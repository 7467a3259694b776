// An allowance is the error that a correct program may have. It must cover the errors of float32 programs
// (tests/harness/mark/correct_programs has many), and be small enough that no mistake passes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "reference/key/answer_key.h"
#include "reference/numbers/affine.h"
#include "tests/given/cases.h"
#include "tests/given/random_scene.h"
#include "tests/given/student/scenes.h"

namespace {

using namespace reference;

Assignment one_reading(std::uint64_t seed) {
    Assignment assignment = random_assignment(seed);
    assignment.rubric.pixel_conventions = {PixelConvention::centre};
    assignment.rubric.boundary = BoundaryPolicy::nonnegative;
    return assignment;
}

const Answer& answer(const AnswerKey& key, const ItemId& id) {
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            if (item.spec.id == id) return item.answers.front();
        }
    }
    throw std::out_of_range(std::string(id.name));
}

template <class T>
void expect_allowed(const Answer& key, const std::vector<T>& given) {
    ASSERT_EQ(key.allowance.size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto x = static_cast<double>(given[i]);
        EXPECT_TRUE(key.lo[i] - key.allowance[i] <= x && x <= key.hi[i] + key.allowance[i])
            << "component " << i << ": " << x << " for [" << key.lo[i] << ", " << key.hi[i] << "] +- "
            << key.allowance[i];
    }
}

/// The allowance only applies to items that a program computes by the same decisions as the key.
void expect_run_allowed(const AnswerKey& key, const AnswerKey& run) {
    for (const KeyQuestion& question : run.questions) {
        for (const KeyItem& item : question.items) {
            SCOPED_TRACE(item.spec.name);
            const Answer& certified = answer(key, item.spec.id);
            const auto* given = std::get_if<Numbers>(&item.answers.front().value);
            if (given != nullptr && std::holds_alternative<Numbers>(certified.value)) expect_allowed(certified, *given);
        }
    }
}

TEST(Allowance, CoversTheStagesInFloatAndInDouble) {
    for (std::uint64_t seed = 0; seed < cases(60); ++seed) {
        SCOPED_TRACE(seed);
        const Assignment assignment = one_reading(seed);
        const AnswerKey key = make_key(assignment, Precision::certified);
        expect_run_allowed(key, make_key(assignment, Precision::float_));
        expect_run_allowed(key, make_key(assignment, Precision::double_));
    }
}

std::vector<float> list(const glm::vec3& p) {
    return {p.x, p.y, p.z};
}

/// Questions 1 to 9 as a student writes them with GLM: lookAt, its inverse, the quadratic without a, Möller and
/// Trumbore.
void expect_student_allowed(const Assignment& assignment, const AnswerKey& key) {
    const Scene<float> scene = convert_scene<float>(assignment.scene, [](const Decimal& x) { return x.to_float(); });
    const auto& window = scene.window;
    const float dx = (window.clip_right - window.clip_left) / static_cast<float>(window.width);
    const float dy = (window.clip_top - window.clip_bottom) / static_cast<float>(window.height);
    const glm::vec4 P_VCS(window.clip_left + dx / 2.0F + static_cast<float>(scene.pixel.x) * dx,
                          window.clip_bottom + dy / 2.0F + static_cast<float>(scene.pixel.y) * dy, -window.clip_near,
                          1);
    const glm::vec3 eye(scene.camera.eye);
    const glm::mat4 M = glm::inverse(glm::lookAt(eye, glm::vec3(scene.camera.lookat), glm::vec3(scene.camera.vup)));
    const glm::vec3 S(M * P_VCS);
    const glm::vec3 V = glm::normalize(S - eye);
    expect_allowed(answer(key, item::P_VCS), list(glm::vec3(P_VCS)));
    expect_allowed(answer(key, item::X_vcs), list(glm::vec3(M[0])));
    std::vector<float> matrix;
    for (int i = 0; i < 16; ++i) matrix.push_back(M[i / 4][i % 4]);
    expect_allowed(answer(key, item::M_VCS_to_WCS), matrix);
    expect_allowed(answer(key, item::P_WCS), list(S));
    expect_allowed(answer(key, item::V), list(V));
    const glm::vec3 C(scene.spheres[0].center);
    const float R = scene.spheres[0].radius;
    const float b = 2 * glm::dot(V, S - C);
    const float c = glm::dot(S - C, S - C) - R * R;
    expect_allowed(answer(key, item::sphere::b), std::vector<float>{b});
    expect_allowed(answer(key, item::sphere::c), std::vector<float>{c});
    expect_allowed(answer(key, item::sphere::d), std::vector<float>{b * b - 4 * c});
    if (key.decisions.of(reference::Subject::sphere) == "hit" && c > 0) {
        const float t = (-b - std::sqrt(b * b - 4 * c)) / 2;
        expect_allowed(answer(key, item::sphere::t), std::vector<float>{t});
        expect_allowed(answer(key, item::sphere::hit), list(S + t * V));
        expect_allowed(answer(key, item::sphere::normal), list(glm::normalize(S + t * V - C)));
    }
    const Triangle<float>& triangle = scene.triangles[0];
    const glm::vec3 e1(triangle.B - triangle.A);
    const glm::vec3 e2(triangle.C - triangle.A);
    const glm::vec3 P = glm::cross(V, e2);
    const glm::vec3 Q = glm::cross(S - glm::vec3(triangle.A), e1);
    const float f = 1 / glm::dot(e1, P);
    expect_allowed(answer(key, item::triangle::t), std::vector<float>{f * glm::dot(e2, Q)});
    expect_allowed(answer(key, item::triangle::u), std::vector<float>{f * glm::dot(S - glm::vec3(triangle.A), P)});
    expect_allowed(answer(key, item::triangle::v), std::vector<float>{f * glm::dot(V, Q)});
    expect_allowed(answer(key, item::triangle::normal), list(glm::normalize(glm::cross(e1, e2))));
}

TEST(Allowance, CoversAStudentsProgramWithGlm) {
    for (std::uint64_t seed = 0; seed < cases(60); ++seed) {
        SCOPED_TRACE(seed);
        const Assignment assignment = one_reading(seed);
        expect_student_allowed(assignment, make_key(assignment, Precision::certified));
    }
}

TEST(Allowance, IsTooSmallForHalfAPixelInTheHandoutsScene) {
    Assignment assignment = load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    assignment.rubric.pixel_conventions = {PixelConvention::centre};
    const AnswerKey centre = make_key(assignment, Precision::certified);
    assignment.rubric.pixel_conventions = {PixelConvention::corner};
    const AnswerKey corner = make_key(assignment, Precision::certified);
    for (const ItemId& id : {item::P_VCS, reference::item::P_WCS, reference::item::V, reference::item::sphere::b,
                             reference::item::sphere::t, reference::item::sphere::normal}) {
        const Answer& key = answer(centre, id);
        const double x = std::get<Numbers>(answer(corner, id).value).front();
        EXPECT_GT(std::abs(x - key.hi.front()), 100 * key.allowance.front()) << id.name;
    }
}

TEST(Allowance, IsWithinTenUnitsInTheLastPlaceOfFloatForTheHandoutsCamera) {
    const AnswerKey key = make_key(load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS), Precision::certified);
    for (const char* name : {"X_vcs", "Y_vcs", "Z_vcs"}) {
        for (const double allowance : answer(key, {Subject::camera, name}).allowance)
            EXPECT_LE(allowance, 10 * 0x1p-23);
    }
}

TEST(Allowance, IsThatOfTheObjectsWhichTheQuestionsAreAbout) {
    // The first of each in the file are behind the others, and so far away that their numbers are a thousand times as
    // coarse.
    const auto key = [](const std::string& objects) {
        return make_key(parse_assignment(student::camera_on_the_axis(4) + objects, "scene.toml"), Precision::certified);
    };
    const std::string far =
        "[[sphere]]\ncenter = [0.1, 0.1, -5000.1]\nradius = 7.1\n"
        "[[triangle]]\nvertices = [[-9000.1, -9000.2, -6000.3], [9000, -9000, -6000], [0, 9000, -6000]]\n";
    const std::string near =
        "[[sphere]]\ncenter = [0.1, 0.1, 0.1]\nradius = 1.1\n"
        "[[triangle]]\nvertices = [[-1.1, -1.2, 0.3], [1.4, -1.7, 0.1], [0.1, 2.3, 0.7]]\n";
    const AnswerKey both = key(far + near), alone = key(near), behind = key(far);
    for (const ItemId& id :
         {reference::item::sphere::c, reference::item::sphere::t, reference::item::sphere::normal,
          reference::item::triangle::t, reference::item::triangle::u, reference::item::triangle::rhs}) {
        EXPECT_EQ(answer(both, id).allowance, answer(alone, id).allowance) << id.name;
        EXPECT_NE(answer(both, id).allowance, answer(behind, id).allowance) << id.name;
    }
}

AnswerKey key_with_triangle(const std::string& vertices) {
    return make_key(
        parse_assignment(student::camera_on_the_axis(4) + "[[triangle]]\nvertices = " + vertices, "scene.toml"),
        Precision::certified);
}

TEST(Allowance, IsInfiniteWhereADivisorMayBeZeroInFloat) {
    const AnswerKey narrow = key_with_triangle("[[-1, -1, 0], [2, 1, 0], [0.5, 0.0000001, 0]]");
    for (const char* name : {"t", "u", "v", "hit"})
        EXPECT_FALSE(std::isfinite(answer(narrow, {Subject::triangle, name}).allowance.front())) << name;
    EXPECT_TRUE(std::isfinite(answer(narrow, item::triangle::rhs).allowance.front()));
}

TEST(WideAllowances, AreNamedWithTheReason) {
    const AnswerKey narrow = key_with_triangle("[[-1, -1, 0], [2, 1, 0], [0.5, 0.0000001, 0]]");
    ASSERT_EQ(narrow.notes.size(), 1U);
    EXPECT_THAT(narrow.notes.front(),
                testing::AllOf(testing::StartsWith("Float is inaccurate for the triangle of this scene."),
                               testing::HasSubstr("other answers rule it out: t of question 8, u of question 8"),
                               testing::HasSubstr("the triangle is narrow. Move a vertex")));
    EXPECT_THAT(key_with_triangle("[[-1, -1, 0], [2, 1, 0], [-1, 2, 0]]").notes, testing::IsEmpty());
}

TEST(WideAllowances, AreToldAsAShareOfTheValue) {
    // d = 4 (R^2 - 0.13) = 4.32 for V = (0, 0, -1): the difference of two numbers of 370,000.
    const AnswerKey key = make_key(
        parse_assignment(student::camera_on_the_axis(4) + "[[sphere]]\ncenter = [0.3, 0.2, -300.3]\nradius = 1.1",
                         "scene.toml"),
        Precision::certified);
    const Answer& d = answer(key, item::sphere::d);
    const double value = std::get<Numbers>(d.value).front();
    ASSERT_NEAR(value, 4.32, 1e-9);
    ASSERT_EQ(key.notes.size(), 1U);
    EXPECT_THAT(
        key.notes.front(),
        testing::AllOf(testing::StartsWith("Float is inaccurate for the sphere of this scene. The answers of a "
                                           "correct program may be off by this share of the value: d of question 6"),
                       testing::HasSubstr(fmt::format("({:.2g} %)", 100 * d.allowance.front() / value)),
                       testing::HasSubstr("the sphere is small compared with its distance. Move it closer")));
}

TEST(WideAllowances, AreNamedUnderWhicheverPixelConvention) {
    // By one of the conventions b is almost 0.
    for (const char* conventions : {R"(["center", "grid"])", R"(["grid", "center"])"}) {
        const AnswerKey key =
            make_key(parse_assignment(
                         "[camera]\neye = [0, 0, 4]\nlookat = [0, 0, 0]\nvup = [0, 1, 0]\n[window]\nclip_left = -2\n"
                         "clip_right = 2\nclip_bottom = -1\nclip_top = 1\nclip_near = 2\nwidth = 31\nheight = 201\n"
                         "pixel = [20, 100]\n[[sphere]]\ncenter = [1.1666666666667, 0, 2.1666666666667]\nradius = 2\n"
                         "[rubric]\npixel_conventions = " +
                             std::string(conventions) + "\n",
                         "scene.toml"),
                     Precision::certified);
        ASSERT_EQ(key.notes.size(), 1U) << conventions;
        EXPECT_THAT(key.notes.front(), testing::AllOf(testing::HasSubstr("b of question 6"),
                                                      testing::HasSubstr("Move the object or the pixel a little")));
    }
}

TEST(Affine, KnowsHowAKnownNumberRounds) {
    Roundings roundings;
    const Affine x = Affine::read(1.0, 0, roundings), y = Affine::read(0x1p-30, 0, roundings);
    EXPECT_EQ((x + x).range().lo(), 2.0) << "exact";
    EXPECT_EQ((x + x).range().hi(), 2.0) << "exact";
    // Float makes 1 of it; a fused or a double result keeps it.
    EXPECT_LE((x + y).range().lo(), 1.0);
    EXPECT_GE((x + y).range().hi(), 1.0 + 0x1p-30);
    EXPECT_LE((x + y).range().hi(), 1.0 + 0x1p-29);
}

TEST(Affine, EnclosesASumInEveryOrder) {
    Roundings roundings;
    const float terms[] = {1e8F, 1.25F, -1e8F, 3.1F};
    Affine x[4];
    for (int i = 0; i < 4; ++i) x[i] = Affine::read(static_cast<double>(terms[i]), 0, roundings);
    const Interval<double> range = sum(x[0], x[1], x[2], x[3]).range();
    int order[] = {0, 1, 2, 3};
    do {
        const float total = ((terms[order[0]] + terms[order[1]]) + terms[order[2]]) + terms[order[3]];
        const float pairs = (terms[order[0]] + terms[order[1]]) + (terms[order[2]] + terms[order[3]]);
        EXPECT_TRUE(range.contains(static_cast<double>(total))) << total;
        EXPECT_TRUE(range.contains(static_cast<double>(pairs))) << pairs;
    } while (std::next_permutation(std::begin(order), std::end(order)));
}

TEST(Affine, EnclosesEitherOfTwoWays) {
    Roundings roundings;
    const Affine one = Affine::read(1.5, 0, roundings), other = Affine::read(1.75, 0, roundings);
    EXPECT_TRUE(either(one, other).range().contains(1.5));
    EXPECT_TRUE(either(one, other).range().contains(1.75));
    EXPECT_LT(either(one, other).range().hi(), 1.751);
    EXPECT_FALSE(either(one, other / Affine(0)).range().is_bounded());
}

/// Six numbers that depend on each other through many roundings.
std::pair<Vec3<Affine>, Vec3<Affine>> six_numbers(int steps, Roundings& roundings) {
    Vec3<Affine> p(Affine::read(0.1, 0, roundings), Affine::read(0.7, 0, roundings), Affine::read(-1.3, 0, roundings));
    Vec3<Affine> q(Affine::read(2.3, 0, roundings), Affine::read(0.3, 0, roundings), Affine::read(0.9, 0, roundings));
    for (int i = 0; i < steps; ++i) {
        const Vec3<Affine> next = cross(p, q);
        p = scaled(next, Affine(1) / sqrt(dot(next, next)));
        q = q + p;
    }
    return {p, q};
}

TEST(Affine, KeepsTheRangeOfEveryLinearCombinationInASummary) {
    Roundings roundings;
    const auto [p, q] = six_numbers(4, roundings);
    Vec3<Affine> short_p = p, short_q = q;
    summarize(short_p, short_q);
    const int factors[][6] = {{1, 0, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 1},   {1, 2, -4, 0, 0, 0},
                              {2, 2, 2, 2, 2, 2}, {4, -2, 1, -1, 8, 2}, {0, 0, 1, -1, 0, 0}};
    for (const auto& factor : factors) {
        const auto combined = [&](const Vec3<Affine>& first, const Vec3<Affine>& second) {
            Affine total;
            for (int i = 0; i < 3; ++i) total += scaled(first, Affine(factor[i]))[i];
            for (int i = 0; i < 3; ++i) total += scaled(second, Affine(factor[i + 3]))[i];
            return total.range().hi() - total.range().lo();
        };
        EXPECT_NEAR(combined(short_p, short_q) / combined(p, q), 1, 1e-3);
    }
}

TEST(Affine, NeverNarrowsARangeInASummary) {
    Roundings roundings;
    auto [p, q] = six_numbers(0, roundings);
    const Vec3<Affine> before = p;
    summarize(p, q);
    for (int i = 0; i < 3; ++i) {
        EXPECT_LE(p[i].range().lo(), before[i].range().lo());
        EXPECT_GE(p[i].range().hi(), before[i].range().hi());
    }
}

TEST(Affine, TracksDependenceOnTheSameRounding) {
    Roundings roundings;
    const Affine x(Interval<double>(1, 2), roundings);
    // In plain intervals x - x is [-1, 1] and x / x is [1/2, 2].
    EXPECT_LT((x - x).range().hi(), 1e-6);
    EXPECT_GT((x - x).range().lo(), -1e-6);
    EXPECT_FALSE((Affine(1) / (x - x)).range().is_bounded());
}

TEST(Affine, CountsTheRoundingsOfAlternativesApartFromLaterOnes) {
    Roundings roundings;
    const Affine x(Interval<double>(1.5 - 0x1p-40, 1.5 + 0x1p-40), roundings);
    Affine before;
    {
        Alternatives ways(roundings);
        before = x * x;
        ways.next();
    }
    // The same product once more, which float may round the other way: each by up to 2^-23.
    const Interval<double> difference = (x * x - before).range();
    EXPECT_TRUE(difference.contains(0x1p-23));
    EXPECT_TRUE(difference.contains(-0x1p-23));
}

TEST(Affine, EnclosesAReciprocalRootFromAnEstimateAndNewton) {
    Roundings roundings;
    for (const double x : {1.5, 2.0, 3.0, 1e-3, 7e5}) {
        const Interval<double> range = reciprocal_root(Affine::read(x, 0, roundings)).range();
        for (const double off : {1.5 * 0x1p-12, -1.5 * 0x1p-12, 0.0}) {  // of x86's rsqrtss, at most
            const double estimate = (1 + off) / std::sqrt(x);
            EXPECT_TRUE(range.contains(estimate * (1.5 - 0.5 * x * estimate * estimate))) << x << " " << off;
        }
    }
}

TEST(Affine, EnclosesEveryResultOfEveryOperation) {
    Roundings roundings;
    const Affine x(Interval<double>(0.5, 3), roundings);
    const Affine y(Interval<double>(-2, -0.25), roundings);
    for (double p = 0.5; p <= 3; p += 0.25) {
        EXPECT_TRUE(sqrt(x).range().contains(std::sqrt(p)));
        for (double q = -2; q <= -0.25; q += 0.25) {
            EXPECT_TRUE((x + y).range().contains(p + q));
            EXPECT_TRUE((x * y).range().contains(p * q));
            EXPECT_TRUE((x / y).range().contains(p / q));
        }
    }
    EXPECT_TRUE(sqrt(Affine(Interval<double>(-1, 4), roundings)).range().contains(2));
    EXPECT_TRUE(sqrt(Affine(Interval<double>(-1, 4), roundings)).range().contains(0));
    EXPECT_FALSE(sqrt(y).range().is_bounded());
}

TEST(Affine, RoundsEachOperationOnceInItsArithmetic) {
    Roundings roundings;
    const Affine third = Affine(Interval<double>(1.0), roundings) / Affine(3);
    EXPECT_TRUE(third.range().contains(static_cast<double>(1.0F / 3.0F)));
    EXPECT_LT(third.range().hi() - third.range().lo(), 0x1p-24);
}

}  // namespace
