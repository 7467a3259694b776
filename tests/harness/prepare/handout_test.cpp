#include "harness/prepare/handout.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <utility>

#include "reference/key/answer_key.h"
#include "tests/given/report/read_page.h"
#include "tests/harness/prepare/named.h"

namespace harness::prepare {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string markdown(const reference::Assignment& assignment, const std::string& student = "") {
    return handout_markdown(assignment, student, "scene.svg");
}

TEST(Handout, StatesTheSceneAndEveryQuestion) {
    EXPECT_THAT(
        markdown(named("a6-2024")),
        AllOf(HasSubstr("- **Camera:** eye (6, 1, 0), lookat (0, 1, 0), vup (0, 1, 0)\n"),
              HasSubstr("- **Pixel:** (x, y) = (200, 150), counted from 0"),
              HasSubstr("center (2, 0, 0), radius R 1, height 4"), HasSubstr("### 4. ray and cylinder (20 points)\n"),
              HasSubstr("- P_c: the point"), HasSubstr("![The scene](scene.svg)")));
    EXPECT_THAT(handout_markdown(named("a6-2024"), "", ""), Not(HasSubstr("![")));
}

/// The letters and digits of a text.
std::string letters(const std::string& text) {
    return std::regex_replace(text, std::regex("[^A-Za-z0-9]"), "");
}

TEST(Handout, HasTheSameTextInBothFormats) {
    for (const char* name : {"a6-2021", "a6-2024"}) {
        std::string page = handout_html(named(name), "Ada (s07)");
        for (const auto& [begin, end] : {std::pair{"<title>", "</title>"}, {"<figure>", "</figure>"}})
            page.erase(page.find(begin), page.find(end) - page.find(begin));
        EXPECT_EQ(letters(report_samples::read_page(page).at("text")),
                  letters(report_samples::read_markdown(handout_markdown(named(name), "Ada (s07)", "")).at("text")))
            << name;
    }
}

TEST(Handout, IsOneWellFormedPageThatLoadsNothing) {
    for (const char* name : {"a6-2021", "a6-2024"}) {
        const std::string page = handout_html(named(name), "");
        const json read = report_samples::read_page(page);
        EXPECT_THAT(read.at("problems"), IsEmpty()) << name;
        EXPECT_EQ(report_samples::xml_problems(page), "") << name;
        EXPECT_EQ(read.at("counts").at("svg"), 1);
        EXPECT_THAT(page, Not(HasSubstr("url(")));
    }
}

TEST(Handout, HasNoAnswer) {
    for (const char* name : {"a6-2021", "a6-2024"}) {
        // Off the center, so that the answers are not numbers of the scene.
        reference::Assignment assignment = named(name);
        assignment.scene.pixel = {assignment.scene.pixel.x + 7, assignment.scene.pixel.y + 5};
        const std::string text = markdown(assignment) + handout_html(assignment, "");
        int compared = 0;
        for (const auto& question : make_key(assignment, reference::Precision::certified).questions) {
            for (const reference::KeyItem& item : question.items) {
                const auto* numbers = std::get_if<reference::Numbers>(&item.answers.front().value);
                if (numbers == nullptr) continue;
                for (const double x : *numbers) {
                    // Short numbers, such as 0 and 1.5, are in every text.
                    if (fmt::format("{:.4g}", x) == fmt::format("{:.10g}", x)) continue;
                    ++compared;
                    EXPECT_THAT(text, Not(HasSubstr(fmt::format("{:.4g}", x)))) << item.spec.name;
                    EXPECT_THAT(text, Not(HasSubstr(fmt::format("{:.4f}", x)))) << item.spec.name;
                }
            }
        }
        EXPECT_GT(compared, 15);
    }
}

TEST(Handout, NamesTheStudentAndTheDueDate) {
    reference::Assignment assignment = named("a6-2021");
    EXPECT_THAT(markdown(assignment), AllOf(Not(HasSubstr("Name:")), Not(HasSubstr("Due:"))));
    assignment.rubric.due = reference::parse_moment("2026-11-05 23:59");
    EXPECT_THAT(markdown(assignment, "Ada (s07)"),
                HasSubstr("- **Name:** Ada (s07)\n- **Due:** Thursday, November 5, 2026, 23:59\n"));
    for (const auto& [due, text] : {std::pair{"2026-11-05 23:59+01:00", "November 5, 2026, 23:59 (UTC+01:00)"},
                                    {"2026-11-05 23:59-03:30", "November 5, 2026, 23:59 (UTC-03:30)"},
                                    {"2026-11-05 00:00Z", "November 5, 2026, 00:00 (UTC)"}}) {
        assignment.rubric.due = reference::parse_moment(due);
        EXPECT_THAT(markdown(assignment), HasSubstr(text));
    }
}

TEST(Handout, StatesPointsThatAddUp) {
    for (const char* name : {"a6-2021", "a6-2024"}) {
        const std::string text = markdown(named(name));
        EXPECT_THAT(text, HasSubstr("- **Points:** 100\n"));
        double sum = 0;
        const std::regex points("### .*\\((.*) points?\\)\n");
        for (auto at = std::sregex_iterator(text.begin(), text.end(), points); at != std::sregex_iterator(); ++at)
            sum += std::stod((*at)[1]);
        EXPECT_EQ(sum, 100) << name;
    }
    reference::Assignment assignment = named("a6-2021");
    assignment.rubric.variant_points = 5;
    EXPECT_THAT(markdown(assignment), HasSubstr("100, and 5 more for right answers on other scenes"));
}

TEST(Handout, ShowsTextOfTheAssignmentAsText) {
    reference::Assignment assignment = named("a6-2021");
    assignment.title = "<b>One</b> & `two` [three](x)\x1b";
    assignment.questions.front().title = "<script>alert(1)</script>";
    const std::string student = "O'Neil \"<i>*Ann*\n";
    for (const json& read : {report_samples::read_page(handout_html(assignment, student)),
                             report_samples::read_markdown(markdown(assignment, student))}) {
        for (const char* element : {"b", "i", "em", "a", "code", "script"})
            EXPECT_FALSE(read.at("counts").contains(element)) << element;
        EXPECT_THAT(read.at("text").get<std::string>(),
                    AllOf(HasSubstr("<b>One</b> & `two` [three](x)\\x1b"), HasSubstr("<script>alert(1)</script>"),
                          HasSubstr("O'Neil \"<i>*Ann*")));
    }
}

TEST(Handout, SaysHowAnswersAreMarked) {
    reference::Assignment assignment = named("a6-2021");
    EXPECT_THAT(markdown(assignment), AllOf(HasSubstr("at (x+1/2)/W or x/(W−1) of its width from the left and "
                                                      "(y+1/2)/H or y/(H−1) of its height"),
                                            HasSubstr("at least 2 decimals")));
    assignment.rubric.pixel_conventions = {reference::PixelConvention::corner};
    assignment.rubric.min_decimals = 4;
    EXPECT_THAT(markdown(assignment), AllOf(HasSubstr("at x/W of its width"), HasSubstr("at least 4 decimals")));
}

TEST(Handout, HasWordsForEveryItem) {
    reference::Assignment assignment = named("a6-2024");
    reference::Question all{1, "everything", {}};
    for (const reference::Item& item : reference::known_items()) all.items.push_back(item.id);
    assignment.questions = {all};
    const std::string text = markdown(assignment);
    std::size_t asked = 0;
    for (std::size_t at = text.find("\n- ", text.find("## Questions")); at != std::string::npos;
         at = text.find("\n- ", at + 1))
        ++asked;
    EXPECT_EQ(asked, reference::known_items().size());
    EXPECT_THAT(text, Not(HasSubstr("first_hit")));
}

TEST(Handout, NumbersTheParts) {
    reference::Assignment assignment = named("a6-2024");
    namespace sphere = reference::item::sphere;
    assignment.questions = {
        {2, "sphere", {sphere::d, sphere::t}, {{"the discriminant", {sphere::d}}, {"", {sphere::t}}}}};
    EXPECT_THAT(markdown(assignment), AllOf(HasSubstr("### 2. sphere (20 points)\n\n"
                                                      "#### a) the discriminant\n"
                                                      "- d: the discriminant"),
                                            HasSubstr("\n#### b)\n- t: where")));
    assignment.rubric.item_points[2] = {{"d", 1}, {"t", 2.5}};
    EXPECT_THAT(markdown(assignment),
                AllOf(HasSubstr("#### a) the discriminant (1 point)\n"), HasSubstr("#### b) (2.5 points)\n")));
    assignment.rubric.item_points[2] = {{"d", 1}};
    EXPECT_THAT(markdown(assignment), HasSubstr("#### b) (0 points)\n")) << "an item that is left out has none";
}

}  // namespace
}  // namespace harness::prepare
