#include "harness/mark/score/mark_transcript.h"

#include <gtest/gtest.h>

#include "tests/given/printed_values.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"

namespace harness {
namespace {

using reference::ItemId;
using student::Program;

/// Marks a program with an integer division in question 1: one item is wrong and many follow from it.
Score with_many_followers(student::Marking marking) {
    for (const student::NamedMistake& mistake : student::named_mistakes()) {
        if (mistake.name == "integer division")
            return mark(print(Program(marking.assignment, {}, mistake.mistake)), marking);
    }
    throw std::logic_error("no such mistake");
}

double followed(const Score& score) {
    double points = 0;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) points += item.verdict == ItemVerdict::follow ? item.points : 0;
    }
    return points;
}

void expect_that_points_add_up(const Score& score) {
    double points = 0, max_points = 0;
    for (const QuestionScore& question : score.questions) {
        double of_items = 0, max_of_items = 0;
        for (const ItemScore& item : question.items) {
            of_items += item.points;
            max_of_items += item.max_points;
            EXPECT_LE(0, item.points);
            EXPECT_LE(item.points, item.max_points);
        }
        EXPECT_NEAR(question.points, of_items, 1e-9) << question.number;
        EXPECT_NEAR(question.max_points, max_of_items, 1e-9) << question.number;
        points += question.points;
        max_points += question.max_points;
    }
    EXPECT_NEAR(score.points, points, 1e-9);
    EXPECT_NEAR(score.max_points, max_points, 1e-9);
}

TEST(Score, IsExactlyAllPointsIfAllIsRight) {
    const student::Marking marking = student::off_axis_scene();
    const Score score = mark(print(Program(marking.assignment, {})), marking);
    EXPECT_EQ(score.points, 100.0);
    EXPECT_EQ(score.max_points, 100.0);
    expect_that_points_add_up(score);
}

/// Marks a program whose sphere normal is not normalized.
ItemScore long_normal(const std::vector<reference::MistakePrice>& prices) {
    student::Marking marking = student::off_axis_scene();
    marking.assignment.rubric.mistakes = prices;
    for (const student::NamedMistake& mistake : student::named_mistakes()) {
        if (mistake.name != "not normalized" || mistake.mistake.item != reference::item::sphere::normal) continue;
        const Score score = mark(print(Program(marking.assignment, {}, mistake.mistake)), marking);
        expect_that_points_add_up(score);
        return item_of(score, reference::item::sphere::normal);
    }
    throw std::logic_error("no such mistake");
}

TEST(Score, GivesAPricedMistakeItsShare) {
    const ItemScore item = long_normal({{"not normalized", 0.4, "a.toml"}});
    EXPECT_EQ(item.verdict, ItemVerdict::wrong);
    EXPECT_EQ(item.diagnosis, "not normalized");
    EXPECT_NEAR(item.points, 4, 1e-9);
    EXPECT_NE(item.advice.find("40 % of the points"), std::string::npos) << item.advice;
}

TEST(Score, AcceptsAMistakeAtFullPrice) {
    const ItemScore item = long_normal({{"not normalized", 1, "a.toml"}});
    EXPECT_EQ(item.verdict, ItemVerdict::right);
    EXPECT_EQ(item.accepted_as, "the rubric accepts the mistake \"not normalized\"");
    EXPECT_EQ(item.points, 10);
}

TEST(Score, PricesAMistakeInItsItemAlone) {
    EXPECT_EQ(long_normal({{"not normalized", 1, "a.toml", reference::item::V}}).verdict, ItemVerdict::wrong);
    EXPECT_EQ(long_normal({{"not normalized", 1, "a.toml", reference::item::sphere::normal}}).verdict,
              ItemVerdict::right);
    EXPECT_EQ(long_normal({{"points inward", 1, "a.toml"}}).points, 0);
}

TEST(Score, IsZeroAndAllMissingForNoOutput) {
    const Score score = mark("", student::off_axis_scene());
    EXPECT_EQ(score.points, 0.0);
    for (const QuestionScore& question : score.questions) {
        EXPECT_EQ(question.verdict, ItemVerdict::missing);
        for (const ItemScore& item : question.items) EXPECT_EQ(item.verdict, ItemVerdict::missing);
    }
}

TEST(Score, GivesCreditForFollowThrough) {
    student::Marking marking = student::off_axis_scene();
    EXPECT_NEAR(with_many_followers(marking).points, 90.0, 1e-9) << "full credit by default";
    marking.assignment.rubric.follow_through = 0.5;
    const Score half = with_many_followers(marking);
    EXPECT_LT(half.points, 90.0);
    expect_that_points_add_up(half);
    marking.assignment.rubric.follow_through = 0;
    EXPECT_EQ(followed(with_many_followers(marking)), 0.0);
}

TEST(Score, CapsTheTotalCreditForFollowThrough) {
    student::Marking marking = student::off_axis_scene();
    const double uncapped = followed(with_many_followers(marking));
    ASSERT_GT(uncapped, 30);
    marking.assignment.rubric.follow_through_cap = 0.2;
    const Score capped = with_many_followers(marking);
    EXPECT_NEAR(followed(capped), 20.0, 1e-9);
    EXPECT_NEAR(capped.points, 90.0 - uncapped + 20.0, 1e-9);
    EXPECT_EQ(capped.follow_cap, 20.0);
    expect_that_points_add_up(capped);
    marking.assignment.rubric.follow_through_cap = 0.0;
    EXPECT_EQ(followed(with_many_followers(marking)), 0.0);
}

TEST(Score, OmitsACapThatCutsNothing) {
    student::Marking marking = student::off_axis_scene();
    marking.assignment.rubric.follow_through_cap = 0.9;
    EXPECT_FALSE(with_many_followers(marking).follow_cap);
    EXPECT_NEAR(with_many_followers(marking).points, 90.0, 1e-9);
}

TEST(Score, AppliesTheCapAfterTheCredit) {
    student::Marking marking = student::off_axis_scene();
    const double uncapped = followed(with_many_followers(marking));
    marking.assignment.rubric.follow_through = 0.5;
    marking.assignment.rubric.follow_through_cap = uncapped / 200 + 0.01;
    EXPECT_NEAR(followed(with_many_followers(marking)), uncapped / 2, 1e-9);
}

TEST(Score, UsesTheRubricsPointsForSingleItems) {
    student::Marking marking = student::off_axis_scene();
    marking.assignment.rubric.points[6] = 10;
    marking.assignment.rubric.item_points[6] = {{"t", 8}, {"hit", 2}};
    const Score score = mark(print(Program(marking.assignment, {})), marking);
    EXPECT_EQ(item_of(score, reference::item::sphere::t).points, 8.0);
    EXPECT_EQ(item_of(score, reference::item::sphere::a).max_points, 0.0);
    expect_that_points_add_up(score);
}

/// A program for the sphere one unit further along x, with a mistake or without, marked under both scenes.
struct OnOwnScene {
    student::Marking given = student::off_axis_scene();
    student::Marking own = given;
    Score score, score_there;

    explicit OnOwnScene(const student::Program::Mistake& mistake = {}) {
        auto& x = own.assignment.scene.spheres.front().center.x;
        x = reference::Decimal::parse(std::to_string(x.to_double() + 1)).value();
        own.key = reference::make_key(own.assignment, reference::Precision::certified);
        const std::string output = print(Program(own.assignment, {}, mistake));
        score = mark(output, given);
        score_there = mark(output, own);
    }
    std::optional<Score> explained() const {
        return explained_by_scene(score, score_there, "Your source sets center = 1", given.assignment.rubric);
    }
};

TEST(OwnScene, GivesCreditForAnswersThatAreRightOnThatScene) {
    OnOwnScene one;
    ASSERT_EQ(item_of(one.score, reference::item::sphere::b).verdict, ItemVerdict::wrong);
    const auto explained = one.explained();
    ASSERT_TRUE(explained);
    const ItemScore& b = item_of(*explained, reference::item::sphere::b);
    EXPECT_EQ(b.verdict, ItemVerdict::follow);
    EXPECT_EQ(b.points, 0.5 * b.max_points);
    EXPECT_EQ(b.diagnosis, own_scene_diagnosis);
    EXPECT_EQ(b.advice, "Your source sets center = 1. This answer is consistent with that scene.");
    EXPECT_EQ(item_of(*explained, reference::item::sphere::t).points,
              item_of(*explained, reference::item::sphere::t).max_points)
        << "it follows from the printed b and c, for the rubric's whole follow_through";
    EXPECT_EQ(item_of(*explained, reference::item::V).verdict, ItemVerdict::right);
    expect_that_points_add_up(*explained);

    one.given.assignment.rubric.wrong_scene_credit = 0.25;
    EXPECT_EQ(item_of(*one.explained(), reference::item::sphere::b).points, 0.25 * b.max_points);
}

TEST(OwnScene, GivesConsistentAnswersTheProductOfBothShares) {
    // P_WCS is wrong, so b and c are wrong under the assignment's sphere, and follow under the source's.
    OnOwnScene one(Program::Mistake{reference::item::P_WCS, [](const Program&, const auto&) {
                                        return std::optional(student::Floats{3, 2, 1});
                                    }});
    one.given.assignment.rubric.follow_through = 0.4;
    ASSERT_EQ(item_of(one.score, reference::item::sphere::c).verdict, ItemVerdict::wrong);
    ASSERT_EQ(item_of(one.score_there, reference::item::sphere::c).verdict, ItemVerdict::follow);
    const auto explained = one.explained();
    ASSERT_TRUE(explained);
    const ItemScore& c = item_of(*explained, reference::item::sphere::c);
    EXPECT_DOUBLE_EQ(c.points, 0.5 * 0.4 * c.max_points);
}

TEST(OwnScene, LeavesNoDoubtAboutAnswersThatAreRightOnThatScene) {
    OnOwnScene one;
    const std::string right =
        item_of(mark(print(Program(one.given.assignment, {})), one.given), reference::item::sphere::b).printed;
    std::string output = print(Program(one.own.assignment, {}));
    output.insert(output.find("Question 7"), "then " + right + " then\n");
    one.score = mark(output, one.given);
    one.score_there = mark(output, one.own);
    ASSERT_TRUE(item_of(one.score, reference::item::sphere::b).doubt) << "the assignment's b stands there, too";
    const auto explained = one.explained();
    ASSERT_TRUE(explained);
    EXPECT_FALSE(item_of(*explained, reference::item::sphere::b).doubt);
}

TEST(OwnScene, IsMentionedInTheAdviceOnAWrongFirstHit) {
    OnOwnScene one;
    std::string output = print(Program(one.own.assignment, {}));
    const std::size_t line = output.rfind("ray hits");
    output.replace(line, output.find('\n', line) - line, "ray hits nothing");
    one.score = mark(output, one.given);
    one.score_there = mark(output, one.own);
    const auto explained = one.explained();
    ASSERT_TRUE(explained);
    const std::string& advice = item_of(*explained, reference::item::first_object).advice;
    EXPECT_TRUE(advice.ends_with(" This may show only because of the different scene in your source.")) << advice;
}

/// A score of one question with an item for each verdict. What is wrong is a named mistake if it is `named`.
Score score_of(const std::vector<ItemVerdict>& verdicts, bool named = false) {
    Score score;
    QuestionScore& question = score.questions.emplace_back();
    question.number = 6;
    for (const ItemVerdict verdict : verdicts) {
        ItemScore& item = question.items.emplace_back();
        item.spec = printed_item(reference::item::sphere::b, "1").spec;
        item.verdict = verdict;
        item.printed = "1";
        if (verdict == ItemVerdict::wrong && named) item.diagnosis = "a mistake";
    }
    return score;
}

TEST(OwnScene, MustExplainMoreThanTheAssignments) {
    using enum ItemVerdict;
    const auto is_explained = [](const Score& given, const Score& own) {
        return explained_by_scene(given, own, "", reference::Rubric()).has_value();
    };
    EXPECT_FALSE(is_explained(score_of({right, wrong}), score_of({wrong, right}))) << "as much";
    EXPECT_TRUE(is_explained(score_of({right, wrong, wrong}), score_of({wrong, right, right}))) << "more";
    EXPECT_FALSE(is_explained(score_of({right, wrong}), score_of({right, wrong}, true))) << "one mistake";
    EXPECT_TRUE(is_explained(score_of({wrong, wrong}), score_of({wrong, wrong}, true))) << "two mistakes";
}

TEST(OwnScene, GivesAWrongAnswerItsDiagnosisOnThatScene) {
    for (const student::NamedMistake& mistake : student::named_mistakes()) {
        if (mistake.name != "factor 2 missing") continue;
        const OnOwnScene one(mistake.mistake);
        const auto explained = one.explained();
        ASSERT_TRUE(explained);
        EXPECT_EQ(item_of(*explained, reference::item::sphere::b).verdict, ItemVerdict::wrong);
        EXPECT_EQ(item_of(*explained, reference::item::sphere::b).diagnosis, "factor 2 missing");
        EXPECT_EQ(item_of(*explained, reference::item::sphere::c).diagnosis, own_scene_diagnosis);
        return;
    }
    FAIL() << "no such mistake";
}

TEST(OwnScene, IsNotUsedIfTheAssignmentsSceneExplainsMore) {
    const OnOwnScene one;
    const student::Marking given = student::off_axis_scene();
    const Score all_right = mark(print(Program(given.assignment, {})), given);
    const Score there = mark(print(Program(given.assignment, {})), one.own);
    EXPECT_FALSE(explained_by_scene(all_right, there, "", given.assignment.rubric));
    EXPECT_FALSE(explained_by_scene(one.score, one.score, "", given.assignment.rubric)) << "nothing is right there";
}

TEST(QuestionVerdict, IsTheWorstOfItsItems) {
    const student::Marking marking = student::off_axis_scene();

    const Score without_t = mark(
        print(Program(marking.assignment, {}), {}, [](const ItemId& id) { return id != reference::item::sphere::t; }),
        marking);
    EXPECT_EQ(without_t.questions[5].verdict, ItemVerdict::missing);
    std::string wrong_too =
        print(Program(marking.assignment, {}), {}, [](const ItemId& id) { return id != reference::item::sphere::hit; });
    wrong_too = student::with_line(wrong_too, 6, "t", "77");
    EXPECT_EQ(mark(wrong_too, marking).questions[5].verdict, ItemVerdict::wrong) << "though an item is missing";
    const Score followed = with_many_followers(marking);
    EXPECT_EQ(followed.questions[0].verdict, ItemVerdict::wrong);
    EXPECT_EQ(followed.questions[3].verdict, ItemVerdict::follow);
    EXPECT_EQ(followed.questions[1].verdict, ItemVerdict::right);
}

TEST(ItemVerdict, HasTheNamesOfTheJsonFormat) {
    EXPECT_EQ(to_string(ItemVerdict::right), "right");
    EXPECT_EQ(to_string(ItemVerdict::follow), "follow");
    EXPECT_EQ(to_string(ItemVerdict::wrong), "wrong");
    EXPECT_EQ(to_string(ItemVerdict::missing), "missing");
    EXPECT_EQ(to_string(ItemVerdict::unreadable), "unreadable");
}

}  // namespace
}  // namespace harness
