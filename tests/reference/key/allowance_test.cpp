// An allowance is the error that a correct program may have. It must be small enough that no mistake passes;
// tests/harness/mark/correct_programs and cylinder_allowance_test.cpp see that it covers the errors of float32
// programs.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "reference/key/answer_key.h"
#include "reference/numbers/affine.h"
#include "tests/given/student/scenes.h"

namespace {

using namespace reference;

const Answer& answer(const AnswerKey& key, const ItemId& id) {
    for (const KeyQuestion& question : key.questions) {
        for (const KeyItem& item : question.items) {
            if (item.spec.id == id) return item.answers.front();
        }
    }
    throw std::out_of_range(std::string(id.name));
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
