#include "harness/report/class/page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "harness/record/marking.h"
#include "tests/given/golden.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/report/read_page.h"
#include "tests/given/student/printout.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string page_of_student(std::size_t index) {
    return fmt::format("feedback/student%20{}.html", index);
}

std::string report_of(const std::vector<Graded>& graded) {
    std::ostringstream page;
    write_class_report(page, graded, marking(), Tier::bwrap, page_of_student);
    return page.str();
}

std::string right_output() {
    return print(student::Program(marking().assignment, {}));
}

Graded with_name(Graded graded, const std::string& name, std::optional<bool> late) {
    graded.submission.lms = LmsName{};
    graded.submission.lms->student = name;
    graded.submission.lms->late = late;
    return graded;
}

TEST(ClassReport, IsAsInTheGoldenFile) {
    const std::vector<Graded> all = telling_class();
    const std::string page = report_of({all.front(), all.back()});
    EXPECT_THAT(read_page(page).at("problems"), IsEmpty());
    EXPECT_TRUE(is_golden(bare(page), "report.html"));
    EXPECT_THAT(read_page(report_of({})).at("problems"), IsEmpty());
}

TEST(ClassReport, CallsOnlyKnownLateSubmissionsLate) {
    const Graded one = graded("one", "");
    const json page = read_page(report_of(
        {with_name(one, "Ada", true), with_name(one, "Ben", std::nullopt), with_name(one, "Cy", false), one}));
    EXPECT_EQ(page.at("rows")[1][2], "late");
    for (int i = 2; i <= 4; ++i) EXPECT_EQ(page.at("rows")[i][2], "") << i;
    EXPECT_THAT(page.at("sheets").at("s1").get<std::string>(), HasSubstr(" · late"));
    EXPECT_THAT(page.at("sheets").at("s2").get<std::string>(), Not(HasSubstr("late")));
    EXPECT_THAT(page.at("text").get<std::string>(), HasSubstr(" late1 "));
    EXPECT_THAT(read_page(report_of({with_name(one, "Ben", std::nullopt)})).at("text").get<std::string>(),
                Not(HasSubstr(" late")));
}

TEST(ClassReport, ShowsAllMarkupAsText) {
    Marking titled = marking();
    titled.assignment.title = markup(0);
    titled.assignment.name = markup(last_markup + 1);
    Graded ungraded = not_graded("bob");
    ungraded.execution.explanation = markup(last_markup + 2);
    Graded asked = markup_everywhere();
    asked.score.questions.front().title = markup(last_markup + 3);
    std::ostringstream out;
    write_class_report(out, {asked, markup_everywhere(), ungraded}, titled, Tier::bwrap, page_of_student);
    const json page = read_page(out.str());
    EXPECT_THAT(page.at("problems"), IsEmpty()) << page.at("problems");
    EXPECT_FALSE(page.at("counts").contains("b")) << page.at("counts");
    for (int n = 0; n <= last_markup + 3; ++n) {
        const bool is_name = n == 3;  // a file name, so the slash is missing
        EXPECT_THAT(page.at("text"), HasSubstr(is_name ? "<b>mark 3<" : markup(n))) << n;
    }
}

TEST(ClassReport, ShowsTheBeginningOfALongText) {
    Graded one = graded("ada", output_with_a_mistake());
    for (std::string* text :
         {&one.execution.run.errors, &one.execution.sanitizer.emplace_back(), &one.submission.notes.emplace_back()})
        *text = std::string(10'000, '!');
    const std::string page = report_of({one});
    EXPECT_THAT(page, HasSubstr(std::string(4'000, '!')));
    EXPECT_THAT(page, Not(HasSubstr(std::string(4'200, '!'))));
}

TEST(ClassReport, IsSmallEnoughToOpenForAThousandSubmissions) {
    std::vector<Graded> graded;
    Graded one = report_samples::graded("student", wrong_everywhere());
    one.execution.build.diagnostics = std::string(60000, '<');
    one.execution.run.errors = std::string(60000, '&');
    for (int i = 0; i < 100; ++i) graded.push_back(one);
    for (int i = 0; i < 900; ++i) {
        graded.push_back(
            report_samples::graded(fmt::format("s{}", i), i % 3 == 0 ? output_with_a_mistake() : right_output()));
    }
    EXPECT_LT(report_of(graded).size(), 15'000'000U);
}

TEST(ClassReport, LinksToTheStudentsPagesIfTheClassIsLarge) {
    std::vector<Graded> many(most_sheets, not_graded("bob"));
    many[0] = many[1] = graded("ada", output_with_a_mistake());
    const std::string small = report_of(many);
    EXPECT_THAT(small, HasSubstr(fmt::format("<article id=\"s{}\"", most_sheets)));
    EXPECT_THAT(small, AllOf(Not(HasSubstr("href=\"feedback/")), Not(HasSubstr("With more than"))));

    many.push_back(hostile());
    const json large = read_page(report_of(many));
    EXPECT_THAT(large.at("problems"), IsEmpty()) << "no link leads to a sheet that is not there";
    EXPECT_THAT(large.at("sheets"), IsEmpty());
    EXPECT_EQ(large.at("rows").size(), many.size() + 1);
    EXPECT_THAT(large.at("text"), HasSubstr(fmt::format("With more than {} students", most_sheets)));
    EXPECT_THAT(large.at("text"), HasSubstr("2 students, question 6, t: far root"));
    const std::vector<std::string> pages = large.at("pages");
    const auto links_to = [&](std::size_t index) { return std::ranges::count(pages, page_of_student(index)); };
    EXPECT_EQ(links_to(0), 2) << "in the table and by the mistake";
    EXPECT_EQ(links_to(2), 2) << "in the table and by the outcome";
    EXPECT_GT(links_to(most_sheets), 2) << "in the table and by each mistake";
}

}  // namespace
}  // namespace harness::report
