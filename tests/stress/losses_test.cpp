// What is lost is told by printed answers on one hard scene: right ones, short ones, nan, and the wrong decision.
#include "harness/stress/losses.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "harness/stress/better_formula.h"
#include "harness/stress/stress_json.h"
#include "harness/stress/stress_sentences.h"
#include "harness/transcript.h"
#include "reference/accuracy/measurement.h"

namespace harness::stress {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A small sphere far along the ray of a6-2021: o(0, 0, 2), d(0, 0, -1).
Marking far_sphere() {
    reference::Assignment assignment = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    const auto decimal = [](const char* text) { return reference::Decimal::parse(text).value(); };
    assignment.scene.spheres.front() = {{decimal("0"), decimal("0"), decimal("-99998")}, decimal("1")};
    assignment.rubric.pixel_conventions = {reference::PixelConvention::centre};
    reference::AnswerKey key = reference::make_key(assignment, reference::Precision::certified);
    return {std::move(assignment), std::move(key)};
}

Score score_of(const std::string& printed, const Marking& marking) {
    return score(read_transcript(printed), marking.key, marking.assignment);
}

/// All right on the scene itself, whatever it is: what counts as looked at.
Score all_right(const Marking& marking) {
    return score_of(reference::to_text(marking.key), marking);
}

/// The right printout with one line of question 6 in place of the right one.
std::vector<HardItem> losses_with(const std::string& label, const std::string& value) {
    const Marking marking = far_sphere();
    std::string text = reference::to_text(marking.key);
    const std::size_t question = text.find("Question 6");
    const std::size_t begin = text.find("\n" + label + ":", question) + 1;
    EXPECT_NE(begin, std::string::npos + 1);
    text.replace(begin, text.find('\n', begin) - begin, label + ": " + value);
    std::vector<HardItem> lost = losses(all_right(marking), score_of(text, marking), marking);
    std::erase_if(lost, [&](const HardItem& item) { return item.item != label; });
    return lost;
}

TEST(Losses, AreNoneInARightPrintout) {
    const Marking marking = far_sphere();
    EXPECT_THAT(losses(all_right(marking), all_right(marking), marking), IsEmpty());
}

TEST(Losses, CountTheRightDigitsOfThePrinted) {
    // d = 4
    const auto lost = losses_with("d", "4.0071");
    ASSERT_EQ(lost.size(), 1U);
    EXPECT_EQ(lost[0].digits_kept, 2);
    EXPECT_EQ(lost[0].digits_printed, 4);
}

TEST(Losses, AreNotWhatAShortPrintoutLeavesOut) {
    EXPECT_THAT(losses_with("d", "4"), IsEmpty());
    EXPECT_THAT(losses_with("d", "4.01"), IsEmpty());
}

TEST(Losses, TellNotANumberApart) {
    for (const char* value : {"nan", "-nan", "inf"}) {
        const auto lost = losses_with("t", value);
        ASSERT_EQ(lost.size(), 1U) << value;
        EXPECT_EQ(lost[0].loss, Loss::not_a_number) << value;
    }
}

TEST(Losses, TellAHitThatIsToldAsAMiss) {
    const auto lost = losses_with("t", "none");
    ASSERT_EQ(lost.size(), 1U);
    EXPECT_EQ(lost[0].loss, Loss::hit_missed);
}

TEST(Losses, AreOnlyOfWhatWasRightOnItsOwnScene) {
    const Marking marking = far_sphere();
    EXPECT_THAT(losses(score_of("", marking), score_of("", marking), marking), IsEmpty());
}

TEST(BetterFormulas, AreNamedAsInTheLadder) {
    const auto sentences = better_formulas(losses_with("t", "100000.50"), far_sphere());
    ASSERT_FALSE(sentences.empty());
    EXPECT_THAT(sentences.front(), AllOf(HasSubstr("naive quadratic float keeps 4 digits"), HasSubstr("Haines float"),
                                         HasSubstr("naive quadratic double keeps 15")));
    EXPECT_THAT(better_formulas({}, far_sphere()), IsEmpty());
}

/// A name without its scalar.
std::string kernel_of(const std::string& name) {
    for (const std::string scalar : {" float interval", " double-double", " 100 digits"}) {
        if (name.ends_with(scalar)) return name.substr(0, name.size() - scalar.size());
    }
    return name.substr(0, name.rfind(' '));
}

TEST(BetterFormulas, HaveALineForEveryFormulaOfTheLadder) {
    for (const auto primitive : {reference::accuracy::Primitive::sphere, reference::accuracy::Primitive::triangle}) {
        for (const std::string& name : reference::accuracy::method_names(primitive)) {
            const std::string kernel = kernel_of(name);
            const bool is_own = name.starts_with("certified") || name.starts_with("conservative");
            EXPECT_EQ(formula_of(kernel).empty(), is_own) << name;
        }
    }
}

StressReport some_report() {
    HardResult lost{"far", "b² is large", "", "radius = 1", "", {}, {"Haines float keeps 6 digits."}};
    lost.items = {{6, "d", Loss::digits, 2, 4, ""}, {6, "t", Loss::not_a_number, 0, 0, "far root"}};
    HardResult left_out{"near", "", "the source was not found to state vup", "", "", {}, {}};
    HardResult kept{"inside", "the far root counts", "", "radius = 7", "", {}, {}};
    return {{"vup"}, {lost, left_out, kept}};
}

TEST(StressReport, CountsWhatSurvives) {
    EXPECT_EQ(some_report().tried(), 2U);
    EXPECT_EQ(some_report().survived(), 1U);
}

TEST(StressReport, IsReadBackAsItWasWritten) {
    const auto json = stress_json(some_report());
    EXPECT_EQ(stress_json(stress_from_json(json)), json);
    auto broken = nlohmann::json(json);
    broken["scenes"][0]["items"][0]["loss"] = "nothing";
    EXPECT_THROW(stress_from_json(broken), std::invalid_argument);
}

TEST(StressSentences, SayWhatIsLostAndWhatWouldDoBetter) {
    const auto sentences = stress_sentences(some_report());
    ASSERT_EQ(sentences.size(), 2U);
    EXPECT_THAT(sentences[0], HasSubstr("1 of 2 hard scenes"));
    EXPECT_THAT(sentences[1], AllOf(HasSubstr("nan or inf: 6.t (far root)"), HasSubstr("6.d (2 of 4 digits)"),
                                    HasSubstr("Haines float keeps 6 digits.")));
    EXPECT_THAT(stress_text(some_report()), HasSubstr("near: left out\n    the source was not found to state vup"));
}

}  // namespace
}  // namespace harness::stress
