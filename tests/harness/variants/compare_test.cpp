#include "harness/variants/compare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/record/variants_sentences.h"

namespace harness::variants {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::SizeIs;
using enum ItemVerdict;

struct Answered {
    std::string printed;
    ItemVerdict verdict;
};

/// t and u of question 8 and the verdict of question 10.
Score answered(const Answered& t, const Answered& u, const Answered& verdict = {"sphere", right}) {
    Score score;
    for (const int number : {8, 10}) {
        score.questions.emplace_back();
        score.questions.back().number = number;
    }
    const auto add = [](QuestionScore& question, std::string_view name, reference::Shape shape,
                        const Answered& answer) {
        ItemScore item;
        item.spec = {question.number, name, shape, "", {reference::Subject::triangle, name}};
        item.printed = answer.printed;
        item.verdict = answer.verdict;
        if (shape != reference::Shape::first_object && !answer.printed.starts_with("none")) item.error = 0;
        question.items.push_back(item);
    };
    add(score.questions[0], "t", reference::Shape::scalar, t);
    add(score.questions[0], "u", reference::Shape::scalar, u);
    add(score.questions[1], "verdict", reference::Shape::first_object, verdict);
    return score;
}

VariantsReport compared(const Score& base, const std::vector<Score>& scores,
                        std::vector<UntriedVariant> not_tried = {}) {
    std::vector<VariantRun> runs;
    for (const Score& score : scores)
        runs.push_back({"scene " + std::to_string(runs.size() + 1), "eye = (1, 2, 3)", "eye = (0, 0, 4)", true, score});
    return compare(base, std::move(runs), std::move(not_tried), {"vup"});
}

std::vector<std::string> names(const std::vector<ItemOnVariant>& items) {
    std::vector<std::string> result;
    for (const ItemOnVariant& item : items) result.push_back(std::to_string(item.question) + "." + item.item);
    return result;
}

Score on(const char* t, ItemVerdict of_t, const char* u = "0.1", ItemVerdict of_u = right) {
    return answered({t, of_t}, {u, of_u});
}

/// What is said of a program by its answers on other scenes.
struct Case {
    const char* what;
    VariantsVerdict verdict;
    std::vector<Score> others;
    std::vector<std::string> unmoved = {};
    std::vector<std::string> broken = {};
    Score base = on("1", right, "0.5");
    std::vector<UntriedVariant> not_tried = {};
};

TEST(CompareVariants, FindsWhetherAnswersMoveAndStayRight) {
    using enum VariantsVerdict;
    Score coarse = on("2.1", wrong);
    coarse.questions[0].items[0].diagnosis = "too few decimals";
    const auto with_sphere = [](const char* t, ItemVerdict of_sphere) {
        return answered({t, right}, {"0.5", right}, {"1 of 2: sphere", of_sphere});
    };
    const Case cases[] = {
        {"all stays right", computes, {on("2", right, "0.5"), on("3", right, "0.25")}},
        {"an unchanged answer is right", computes, {on("2", right, "0.5"), on("3", right, "0.5")}},
        {"an answer follows from a mistake", computes, {on("2", right, "0.7", follow)}},
        {"larger numbers need more digits", computes, {coarse}},
        {"wrong before", computes, {on("1", wrong), on("1", wrong, "0.2")}, {}, {}, on("1", wrong, "0.5")},
        {"becomes wrong or missing", breaks, {on("2", wrong), on("", missing)}, {}, {"8.t", "8.t"}},
        {"two break", breaks, {2, on("2", wrong, "0.1", wrong)}, {}, {"8.t", "8.u", "8.t", "8.u"}},
        {"a coincidence", breaks, {on("7", wrong), on("7", right)}, {}, {"8.t"}, on("7", right, "0.5")},
        {"any different print", breaks, {on("1", wrong), on("1.5", wrong)}, {}, {"8.t", "8.t"}},
        {"the sentence of question 10 has few values",
         breaks,
         {with_sphere("2", wrong), with_sphere("3", wrong)},
         {},
         {"10.verdict", "10.verdict"},
         with_sphere("1", right)},
        {"wrong twice", does_not_move, {on("2", right, "0.5", wrong), on("3", right, "0.5", follow)}, {"8.u"}},
        {"others break", does_not_move, {2, on("2", wrong, "0.5", wrong)}, {"8.u"}, {"8.t", "8.t"}},
        {"blanks", does_not_move, {on("(1,  2)", wrong), on("(1,\t2)\n", wrong)}, {"8.t"}, {}, on("(1, 2)", right)},
        {"the only run that was wanted", does_not_move, {on("2", right, "0.5", wrong)}, {"8.u"}},
        {"others failed", breaks, {on("2", right, "0.5", wrong)}, {}, {"8.u"}, on("1", right, "0.5"), {{"a", "", "x"}}},
    };
    for (const Case& each : cases) {
        const VariantsReport report = compared(each.base, each.others, each.not_tried);
        EXPECT_EQ(report.verdict, each.verdict) << each.what;
        EXPECT_EQ(names(report.unmoved), each.unmoved) << each.what;
        EXPECT_EQ(names(report.broken), each.broken) << each.what;
        EXPECT_EQ(report.not_tried.size(), each.not_tried.size()) << each.what;
    }
}

TEST(CompareVariants, CountsAnswersThatMoveAndForgetsTheScores) {
    const VariantsReport report =
        compared(answered({"1", right}, {"0.5", right}),
                 {answered({"2", right}, {"0.5", right}), answered({"3", wrong}, {"0.5", right})});
    EXPECT_EQ(report.moved, 1);
    EXPECT_EQ(report.broken.at(0).run, 1U);
    EXPECT_THAT(report.not_found, ElementsAre("vup"));
    for (const VariantRun& run : report.runs) EXPECT_THAT(run.score.questions, IsEmpty());
}

TEST(CompareVariants, GivesEachRunItsShareOfThePoints) {
    Score three_quarters = answered({"2", right}, {"0.1", wrong});
    three_quarters.points = 3;
    three_quarters.max_points = 4;
    Score one_quarter = answered({"3", wrong}, {"0.2", wrong});
    one_quarter.points = 5;
    one_quarter.max_points = 20;
    const VariantsReport report = compared(answered({"1", right}, {"0.5", right}),
                                           {three_quarters, one_quarter, answered({"", missing}, {"", missing})});
    ASSERT_THAT(report.runs, SizeIs(3));
    EXPECT_EQ(report.runs[0].share, 0.75);
    EXPECT_EQ(report.runs[1].share, 0.25);
    EXPECT_EQ(report.runs[2].share, 0);
}

TEST(CompareVariants, IgnoresNoneAndZero) {
    for (const std::string print : {"none", "none, as d = -12", "0.000", "-0"}) {
        const VariantsReport report =
            compared(answered({print, right}, {"0.5", right}),
                     {answered({print, wrong}, {"0.1", right}), answered({print, wrong}, {"0.2", right})});
        EXPECT_EQ(report.verdict, VariantsVerdict::breaks) << print;
        EXPECT_THAT(report.unmoved, IsEmpty());
    }
}

TEST(CompareVariants, FindsNothingWithoutARun) {
    EXPECT_EQ(compared(answered({"1", right}, {"0.5", right}), {}).verdict, VariantsVerdict::not_found);
    EXPECT_THAT(variants_sentences(compared(answered({"1", right}, {"0.5", right}), {})), IsEmpty());
}

TEST(VariantsSentences, ShowTheEvidenceSideBySide) {
    const VariantsReport report =
        compared(answered({"1", right}, {"0.50", right}),
                 {answered({"1", wrong}, {"0.50", wrong}), answered({"1", wrong}, {"0.50", wrong})});
    EXPECT_EQ(
        unmoved_evidence(report),
        "Question 8, u: the program prints 0.50 with eye = (0, 0, 4), and 0.50 with eye = (1, 2, 3) in its source. "
        "The same is true of question 8 (t). No other answer changes.");
    EXPECT_THAT(variants_sentences(report),
                ElementsAre(HasSubstr("2 other scenes"),
                            "The printed numbers of question 8 (t, u) do not change with the scene in the source."));
}

TEST(VariantsSentences, CountAnswersThatChanged) {
    const auto evidence = [](const Score& base, const Score& other) {
        return unmoved_evidence(compared(base, {other}));
    };
    EXPECT_THAT(evidence(answered({"1", right}, {"0.5", right}), answered({"2", right}, {"0.5", wrong})),
                HasSubstr("in its source. 1 right answer changed."));
    EXPECT_THAT(evidence(answered({"1", right}, {"0.5", right}, {"sphere", right}),
                         answered({"2", right}, {"0.5", wrong}, {"triangle", right})),
                HasSubstr("in its source. 2 right answers changed."));
}

TEST(VariantsSentences, NameUntriedScenesWithTheReason) {
    const UntriedVariant compiles{"triangle in front", "radius = 3", "the source does not compile with its numbers"};
    const UntriedVariant fails{"far sphere, grazed", "radius = 3", "something went wrong"};
    const UntriedVariant without{"", "", "no further one"};
    const Score base = answered({"1", right}, {"0.5", right});
    const auto sentences = variants_sentences(
        compared(base, {answered({"2", right}, {"0.1", right})}, {compiles, fails, compiles, without}));
    ASSERT_THAT(sentences, SizeIs(5));
    EXPECT_THAT(sentences[0], HasSubstr("also run on 1 other scene ("));
    EXPECT_THAT(
        sentences,
        IsSupersetOf({"The program could not be run on 2 of 5 other scenes (triangle in front; triangle in "
                      "front): the source does not compile with its numbers.",
                      "The program could not be run on 1 of 5 other scenes (far sphere, grazed): something went "
                      "wrong.",
                      "The program could not be run on 1 of 5 other scenes: no further one."}));
    EXPECT_THAT(variants_sentences(compared(base, {}, {compiles, compiles})),
                ElementsAre("The program could not be run on any of 2 other scenes: the source does not compile with "
                            "its numbers."));
    EXPECT_THAT(variants_sentences(compared(base, {}, {fails})),
                ElementsAre("The program could not be run on another scene: something went wrong."));
}

TEST(VariantsSentences, NameBrokenAnswersWithTheirScene) {
    Score score = answered({"2", wrong}, {"", missing});
    score.questions[0].items[0].diagnosis = "far root";
    const auto sentences = variants_sentences(compared(answered({"1", right}, {"0.5", right}), {score}));
    ASSERT_THAT(sentences, SizeIs(2));
    EXPECT_THAT(sentences[0], HasSubstr("on 1 other scene ("));
    EXPECT_EQ(sentences[1],
              "With eye = (1, 2, 3) (scene 1), these are no longer right: question 8 (t: far root, u: not printed).");
}

}  // namespace
}  // namespace harness::variants
