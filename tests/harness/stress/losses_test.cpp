// Losses of printed answers on a hard scene: right answers, short answers, nan, and wrong decisions.
#include "harness/stress/losses.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "reference/key/key_formats.h"
#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"

namespace harness::stress {
namespace {

using reference::PixelConvention;
using student::with_line;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

/// Restricts the rubric to one pixel convention, as hard scenes do, and computes the key again.
student::Marking held(student::Marking marking, PixelConvention convention = PixelConvention::centre) {
    marking.assignment.rubric.pixel_conventions = {convention};
    marking.key = reference::make_key(marking.assignment, reference::Precision::certified);
    return marking;
}

/// A small sphere far along the ray of a6-2021: o(0, 0, 2), d(0, 0, -1).
student::Marking far_sphere() {
    student::Marking marking = student::handout_scene();
    const auto decimal = [](const char* text) { return reference::Decimal::parse(text).value(); };
    marking.assignment.scene.spheres.front() = {{decimal("0"), decimal("0"), decimal("-99998")}, decimal("1")};
    return held(std::move(marking));
}

/// A printout with the right answers of the scene. losses() only examines answers that are right on the original scene.
std::string right_printout(const student::Marking& marking) {
    return reference::to_text(marking.key);
}

std::vector<HardItem> losses_of(const std::string& printed, const student::Marking& marking) {
    return losses(::mark(right_printout(marking), marking), ::mark(printed, marking),
                  {marking.assignment, marking.key});
}

/// The same in words: "6.t: hit_missed".
std::vector<std::string> losses_in_words(const std::string& printed, const student::Marking& marking) {
    std::vector<std::string> losses;
    for (const HardItem& item : losses_of(printed, marking))
        losses.push_back(fmt::format("{}.{}: {}", item.question, item.item, to_string(item.loss)));
    return losses;
}

/// The right printout of a far sphere with one value of question 6 replaced.
std::string far_sphere_with(const std::string& label, const std::string& value) {
    return with_line(right_printout(far_sphere()), 6, label, value);
}

/// The right printout in which `words` replace the lines of question 6 from "t: none" on.
std::string without_sphere(const student::Marking& marking, const std::string& words) {
    std::string printed = right_printout(marking);
    const std::size_t t = printed.find("\nt: none", printed.find("Question 6:"));
    const std::size_t question_7 = printed.find("\nQuestion 7:");
    printed.replace(t, question_7 - t, "\n" + words);
    return printed;
}

/// The right printout with a different sentence at the end.
std::string with_verdict(std::string printed, const std::string& sentence) {
    const std::size_t line = printed.rfind("ray hits");
    return printed.replace(line, printed.find('\n', line) - line, sentence);
}

TEST(Losses, AreNoneInARightPrintout) {
    std::size_t number = 0;
    for (const std::string_view scene : student::scene_names()) {
        if (number++ % 6 != 0) continue;
        const student::Marking marking = held(student::scene_named(scene));
        EXPECT_THAT(losses_in_words(right_printout(marking), marking), IsEmpty()) << scene;
    }
}

/// Those that count on a scene about this object, as "6.t".
std::vector<std::string> counted(const std::vector<HardItem>& lost, std::optional<reference::Subject> about) {
    std::vector<std::string> names;
    for (const HardItem& item : that_count(lost, about, held(student::handout_scene()).key))
        names.push_back(std::to_string(item.question) + "." + item.item);
    return names;
}

TEST(Losses, CountOnScenesAboutTheirOwnObject) {
    using reference::Subject;
    const HardItem V{5, "V", Loss::digits, 2, 6, ""}, t{6, "t", Loss::miss_hit, 0, 0, ""},
        u{8, "u", Loss::wrong, 0, 0, ""}, verdict{10, "verdict", Loss::other_first, 0, 0, ""};
    EXPECT_THAT(counted({V, t, u, verdict}, Subject::sphere), ElementsAre("6.t"));
    EXPECT_THAT(counted({V, t, u, verdict}, Subject::triangle), ElementsAre("8.u"));
    EXPECT_THAT(counted({V, t, u, verdict}, std::nullopt), ElementsAre("5.V", "6.t", "8.u"));
    EXPECT_THAT(counted({u, verdict}, Subject::triangle), ElementsAre("8.u", "10.verdict"));
    EXPECT_THAT(counted({verdict}, Subject::triangle), ElementsAre("10.verdict"));
    EXPECT_THAT(counted({t, verdict}, Subject::triangle), IsEmpty()) << "the sphere's mistake decides";
}

TEST(Losses, CountTheRightDigitsOfThePrinted) {
    // d = 4
    const auto lost = losses_of(far_sphere_with("d", "4.0071"), far_sphere());
    ASSERT_EQ(lost.size(), 1U);
    EXPECT_EQ(lost[0].item, "d");
    EXPECT_EQ(lost[0].digits_kept, 2);
    EXPECT_EQ(lost[0].digits_printed, 4);
}

TEST(Losses, CountTheDigitsOfNumbersWhoseNamesHoldDigits) {
    std::string printed = with_line(right_printout(far_sphere()), 5, "V", "");
    printed.replace(printed.find("\nV: "), 4, "\nV[0] = 0.001200, V[1] = 0.000000, V[2] = -1.000000");
    const auto lost = losses_of(printed, far_sphere());
    ASSERT_FALSE(lost.empty());
    EXPECT_EQ(lost[0].item, "V");
    EXPECT_EQ(lost[0].digits_kept, 2);
    EXPECT_EQ(lost[0].digits_printed, 6);
}

TEST(Losses, ExcludeDigitsThatAShortPrintoutOmits) {
    EXPECT_THAT(losses_in_words(far_sphere_with("d", "4"), far_sphere()), IsEmpty());
    EXPECT_THAT(losses_in_words(far_sphere_with("d", "4.01"), far_sphere()), IsEmpty());
}

TEST(Losses, DistinguishNan) {
    for (const char* value : {"nan", "-nan", "inf"})
        EXPECT_THAT(losses_in_words(far_sphere_with("t", value), far_sphere()), Contains("6.t: not_a_number")) << value;
}

TEST(Losses, DistinguishAWrongNumberFromNone) {
    EXPECT_THAT(losses_in_words(far_sphere_with("c", "123.5"), far_sphere()), Contains("6.c: wrong"));
    EXPECT_THAT(losses_in_words(far_sphere_with("c", ""), far_sphere()), Contains("6.c: missing"));
    EXPECT_THAT(losses_in_words(far_sphere_with("P_s", "0.5"), far_sphere()), Contains("6.hit: missing"))
        << "unreadable";
}

TEST(Losses, IncludeAHitReportedAsAMiss) {
    EXPECT_THAT(losses_in_words(far_sphere_with("t", "none"), far_sphere()), Contains("6.t: hit_missed"));
    EXPECT_THAT(losses_in_words(far_sphere_with("t", "none (d = -4 < 0)"), far_sphere()), Contains("6.t: hit_missed"));
}

TEST(Losses, IncludeAMissReportedAsAHit) {
    const student::Marking marking = held(student::scene_named("sphere missed"));
    EXPECT_THAT(losses_in_words(with_line(right_printout(marking), 6, "t", "4.2426"), marking),
                Contains("6.t: miss_hit"));
}

// Words that say that there is no value may contain numbers.
TEST(Losses, AreEmptyForARightNoneWithAnyWords) {
    const student::Marking marking = held(student::scene_named("sphere missed"));
    for (const char* words :
         {"t: none (d < 0)", "t: none (t is nan)", "t: no hit, since -12.25 < 0", "t = -1 (-1 means no hit)",
          "No intersection: discriminant -12 < 0", "t: none (d < 0)\nP_s: none (d < 0)\nt: none (t is nan)"}) {
        EXPECT_THAT(losses_in_words(without_sphere(marking, words), marking), IsEmpty()) << words;
    }
}

TEST(Losses, IncludeAWrongFirstObject) {
    const student::Marking marking = held(student::off_axis_scene());
    EXPECT_THAT(losses_in_words(with_verdict(right_printout(marking), "ray hits triangle first"), marking),
                ElementsAre("10.verdict: other_first"));
}

// Marking forgives decisions that float can't make. A hard scene reports them as losses.
TEST(Losses, IncludeDecisionsThatMarkingForgives) {
    const student::Marking hit = held(student::scene_named("barely hit"));
    std::string missed = right_printout(hit);
    missed = with_line(missed, 6, "d", "-0.000004");
    missed = with_line(missed, 6, "t", "none");
    missed = with_line(missed, 6, "P_s", "none");
    missed = with_line(missed, 7, "N", "none");
    ASSERT_EQ(verdict_on(::mark(missed, hit), reference::item::sphere::t), "right");
    EXPECT_THAT(losses_in_words(missed, hit),
                IsSupersetOf({"6.t: hit_missed", "6.hit: hit_missed", "7.normal: hit_missed"}));

    const student::Marking miss = held(student::scene_named("barely missed"));
    std::string touched = with_line(right_printout(miss), 6, "d", "0.000001");
    touched = with_line(touched, 6, "t", "4.999500");
    ASSERT_EQ(verdict_on(::mark(touched, miss), reference::item::sphere::t), "right");
    EXPECT_THAT(losses_in_words(touched, miss), Contains("6.t: miss_hit"));

    const student::Marking tie = held(student::scene_named("almost a tie"));
    for (const char* sentence : {"ray hits sphere first", "ray hits triangle first"}) {
        const std::string printed = with_verdict(right_printout(tie), sentence);
        ASSERT_EQ(verdict_on(::mark(printed, tie), reference::item::first_object), "right") << sentence;
        const bool is_true = right_printout(tie).find(sentence) != std::string::npos;
        EXPECT_EQ(losses_in_words(printed, tie).empty(), is_true) << sentence;
    }
}

TEST(Losses, IncludeOnlyAnswersThatWereRightOnTheOriginalScene) {
    const student::Marking marking = far_sphere();
    EXPECT_THAT(losses(::mark("", marking), ::mark("", marking), {marking.assignment, marking.key}), IsEmpty());
}

TEST(OwnConvention, IsTheConventionThatThePrintoutWasAcceptedUnder) {
    student::Marking marking = student::handout_scene();
    marking.assignment.scene.pixel = {40, 30};
    marking.key = reference::make_key(marking.assignment, reference::Precision::certified);
    for (const auto convention : {PixelConvention::centre, PixelConvention::grid}) {
        const std::string printed = right_printout(held(marking, convention));
        EXPECT_EQ(own_convention(::mark(printed, marking), marking.key), convention);
    }
    EXPECT_EQ(own_convention(::mark("", marking), marking.key), PixelConvention::centre);
}

HardItem lost_item(int question, const std::string& name) {
    HardItem item;
    item.question = question;
    item.item = name;
    return item;
}

/// The ray of a6-2021 from (0, 0, 2) along -z.
student::Marking with_sphere(const char* x, const char* z, const char* radius) {
    student::Marking marking = student::handout_scene();
    const auto decimal = [](const char* text) { return reference::Decimal::parse(text).value(); };
    marking.assignment.scene.spheres.front() = {{decimal(x), decimal("0"), decimal(z)}, decimal(radius)};
    return held(std::move(marking));
}

std::string advice_on(const student::Marking& marking, const HardItem& lost) {
    return advice({lost}, {marking.assignment, marking.key});
}

TEST(Advice, IsTriedOnTheScene) {
    EXPECT_EQ(advice({}, {far_sphere().assignment, far_sphere().key}), "");
    const auto easy = with_sphere("1", "-20", "4");
    EXPECT_EQ(advice_on(easy, lost_item(6, "t")), "Not a rounding error: the handout's formulas work.");
    // b² is 6.4e7 and 4ac 6.4e4, both exact in float: only -b - √d loses digits.
    const auto near = with_sphere("3", "-4000", "4000");
    EXPECT_EQ(advice_on(near, lost_item(6, "t")), "Use the stable root, t = c / q.");
    // c is the difference of two numbers around 2.5e13, of which float has the first seven digits.
    const auto huge = with_sphere("1", "-5000001", "5000002.5");
    EXPECT_EQ(advice_on(huge, lost_item(6, "c")), "Use double.");
    // t is 0.3, and √d is 2e12.
    const auto planet = with_sphere("4", "-1000000000000", "1000000000001.7");
    EXPECT_EQ(advice_on(planet, lost_item(6, "t")), "Double is wrong too: decide exactly.");
}

}  // namespace
}  // namespace harness::stress
