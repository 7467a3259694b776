#include "harness/report/class/page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "harness/record/marking.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/report/read_page.h"
#include "tests/given/student/printout.h"

namespace harness::report {
namespace {

using namespace report_samples;
using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
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

TEST(ClassReport, ParsesWithoutErrors) {
    Graded one = graded("ada", output_with_a_mistake());
    one.execution.build.diagnostics = "ray_cast.cpp:3:5: warning: unused variable 'x'\n";
    one.execution.run.errors = "oops\n";
    one.execution.sanitizer = {"ray_cast.cpp:7:9: runtime error: division by zero"};
    for (const auto& graded : std::vector<std::vector<Graded>>{
             {one, hostile(), not_graded("bob"), graded("nil", "")}, {not_graded("bob")}, {}}) {
        const json page = read_page(report_of(graded));
        EXPECT_THAT(page.at("problems"), IsEmpty()) << page;
        EXPECT_EQ(page.at("sheets").size(), graded.size());
        EXPECT_EQ(page.at("rows").size(), graded.size() + 1);
    }
}

TEST(ClassReport, HasARowPerSubmissionWithPointsByQuestion) {
    const Graded ada = with_name(graded("ada_7", output_with_a_mistake()), "Ada Ó Briain", true);
    const json rows = read_page(report_of({ada, not_graded("bob")})).at("rows");
    EXPECT_THAT(rows[0], ElementsAre("Name", "Id", "Late", "Outcome", "Q1", "Q2", "Q3", "Q4", "Q5", "Q6", "Q7", "Q8",
                                     "Q9", "Q10", "Points", "Flags"));
    EXPECT_THAT(rows[1], ElementsAre("Ada Ó Briain", "ada_7", "late", "finished", "10", "10", "10", "10", "10", "8.33",
                                     "10", "10", "10", "10", "98.33", ""));
    EXPECT_EQ(rows[2][3], "not graded");
    EXPECT_EQ(rows[2][14], "–");
}

TEST(ClassReport, HasNoColumnOfNamesThatSayNoMoreThanTheIds) {
    Graded one = with_name(graded("rossigiulia", output_with_a_mistake()), "rossigiulia", false);
    const json page = read_page(report_of({one}));
    EXPECT_THAT(page.at("rows")[0][0], "Id");
    EXPECT_THAT(page.at("rows")[0][1], "Late");
    EXPECT_THAT(page.at("sheets").at("s1").get<std::string>(),
                testing::StartsWith("rossigiuliarossigiulia/ray_cast.cpp"));
    one.submission.name = "Rossi, Giulia";
    const json named = read_page(report_of({one}));
    EXPECT_THAT(named.at("rows")[1][0], "Rossi, Giulia");
    EXPECT_THAT(named.at("rows")[1][1], "rossigiulia");
    EXPECT_THAT(named.at("sheets").at("s1").get<std::string>(), testing::StartsWith("Rossi, Giuliarossigiulia · "));
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

TEST(ClassReport, ColoursLostPointsAndDrawsTheSceneForLostGeometry) {
    const std::string page = report_of({graded("ada", output_with_a_mistake()), graded("bob", right_output())});
    EXPECT_THAT(page, HasSubstr("<td class=\"number q part\">8.33</td>"));
    EXPECT_THAT(page, Not(HasSubstr("number q zero")));
    EXPECT_THAT(page, HasSubstr("aria-labelledby=\"p1-t"));
    EXPECT_THAT(page, Not(HasSubstr("aria-labelledby=\"p2-t"))) << "a picture of what is right shows nothing";
    EXPECT_THAT(report_of({graded("dan", wrong_everywhere())}), HasSubstr("<td class=\"number q zero\">0</td>"));
}

TEST(ClassReport, ShowsPrintedAnswersNextToExpectedAnswers) {
    const json page = read_page(report_of({graded("ada", wrong_everywhere())}));
    const std::string sheet = page.at("sheets").at("s1");
    EXPECT_THAT(sheet, HasSubstr("70.25"));
    std::size_t found = 0;
    const std::vector<std::string> traces = traces_of_key();
    for (const std::string& trace : traces) found += sheet.find(trace) != std::string::npos ? 1 : 0;
    EXPECT_GT(found, traces.size() / 2);
    EXPECT_THAT(sheet, HasSubstr("Off by "));
}

TEST(ClassReport, HoldsThePrintoutAndTheSourceWithLinksToTheirLines) {
    Graded one = graded("ada", output_with_a_mistake());
    one.execution.printout = output_with_a_mistake();
    one.submission.source = "int main() {\n    double t = 3.41421;\n}\n";
    one.submission.source_sha256 = "00";
    one.execution.build.diagnostics = "ray_cast.cpp:1:5: warning: main returns nothing\n";
    one.findings.flags = {{"hard_coded", "6.t: 3.41421 in line 2"}};
    Graded bob = not_graded("bob");
    bob.submission.source_sha256.clear();  // there was no source
    const std::string page = report_of({one, bob});
    const json read = read_page(page);
    EXPECT_THAT(read.at("problems"), IsEmpty()) << "each link leads to a line that is there";
    const std::string sheet = read.at("sheets").at("s1");
    EXPECT_THAT(sheet,
                AllOf(HasSubstr("What it printed 1"), HasSubstr("6.t wrong"), HasSubstr("Its source 1int main() {"),
                      HasSubstr("2 double t = 3.41421; printed as a constant")));
    EXPECT_THAT(
        page, AllOf(HasSubstr("<a href=\"#s1-c2\">line 2</a>"), HasSubstr("<a href=\"#s1-c1\">Line 1</a>"),
                    HasSubstr(fmt::format("<a href=\"#s1-o{0}\">line {0}</a>", one.score.questions[5].items[4].line))));
    EXPECT_THAT(read.at("sheets").at("s2").get<std::string>(),
                AllOf(Not(HasSubstr("Its source")), Not(HasSubstr("What it printed"))));
    one.submission.source.clear();
    EXPECT_THAT(read_page(report_of({one})).at("sheets").at("s1").get<std::string>(),
                HasSubstr("Its source is not kept here"));
}

TEST(ClassReport, ShowsTheAutomaticMarkNextToAnOverride) {
    Graded ada = graded("ada", output_with_a_mistake());
    ada.review.overrides = {{6, "t", 0.5, "half right", "prof", "2026-11-22T09:30:00Z"},
                            {6, "t", 1, "a <good> idea", "prof", "2026-11-22T09:40:00Z"}};
    const json page = read_page(report_of({ada}));
    EXPECT_EQ(page.at("rows")[1][12], "99.33");
    EXPECT_EQ(page.at("rows")[1][13], "override");
    const std::string sheet = page.at("sheets").at("s1");
    EXPECT_THAT(sheet, HasSubstr("Override: 1 points for question 6, t, by prof, 2026-11-22T09:40:00Z: a <good> idea"));
    EXPECT_THAT(sheet, HasSubstr("half right (a later override counts)"));
    EXPECT_THAT(sheet, HasSubstr("Marked automatically: 98.33 of 100 points."));
    EXPECT_THAT(sheet, HasSubstr("wrong0 1 of 1.67"));
}

TEST(ClassReport, CountsVariantsAndNamesTheirUselessOverrides) {
    Graded ada = graded_on_variants("ada");
    const auto sheet = [&] { return read_page(report_of({ada})).at("sheets").at("s1").get<std::string>(); };
    EXPECT_THAT(sheet(), AllOf(HasSubstr("Other scenes: 6 of 10 points."), HasSubstr("104.33 of 110 points")));
    ada.review.overrides = {{0, "variants", 9, "it works", "prof", "2026-11-22T09:40:00Z"}};
    EXPECT_THAT(sheet(), AllOf(HasSubstr("Other scenes: 9 of 10 points."), HasSubstr("107.33 of 110 points"),
                               HasSubstr("9 points for the other scenes, by prof, 2026-11-22T09:40:00Z: it works"),
                               Not(HasSubstr("no such points"))));
    ada.score.variants.reset();
    EXPECT_THAT(sheet(),
                AllOf(Not(HasSubstr("Other scenes:")), HasSubstr("it works (the rubric has no such points any more)")));
}

TEST(ClassReport, SaysForEachSubmissionWhatCountsAndWhatToLookAt) {
    Graded ada = graded("ada", output_with_a_mistake());
    ada.findings.flags = {{"nondeterministic", "Question 1: run 1 printed 1"}};
    ada.execution.sanitizer = {"ray_cast.cpp:7:9: runtime error: division by zero"};
    ada.review.overrides = {{6, "t", 1, "a good idea", "prof", "2026-11-22T09:30:00Z"}};
    ada.late_share = 0.1;
    const json page = read_page(report_of({ada}));
    EXPECT_EQ(page.at("rows")[1][7], "9.33") << "question 6 with the override";
    EXPECT_EQ(page.at("rows")[1][12], "89.4");
    EXPECT_EQ(page.at("rows")[1][13], "nondeterministic sanitizer override");
    const std::string sheet = page.at("sheets").at("s1");
    EXPECT_THAT(sheet, HasSubstr("89.4 of 100 points"));
    EXPECT_THAT(sheet, HasSubstr("Late: 9.93 points are taken off."));
    EXPECT_THAT(sheet, HasSubstr("Look at question 6 first"));
}

TEST(ClassReport, ListsSubmissionsTogetherAndSaysIfThereAreNone) {
    std::vector<Graded> many(13, graded("ada", output_with_a_mistake()));
    const std::string text = read_page(report_of(many)).at("text");
    EXPECT_THAT(text, HasSubstr("13 students"));
    EXPECT_THAT(text, HasSubstr("all others"));
    EXPECT_THAT(text, Not(HasSubstr("There are none.")));
    EXPECT_THAT(read_page(report_of({graded("bob", right_output())})).at("text"), HasSubstr("There are none."));
}

TEST(ClassReport, GroupsStudentsByMistake) {
    const json page = read_page(report_of({graded("ada", output_with_a_mistake()), graded("bob", right_output()),
                                           graded("cem", output_with_a_mistake()), graded("dan", wrong_everywhere())}));
    EXPECT_THAT(page.at("text"), HasSubstr("2 students, question 6, t: far root. That is the far root"));
    EXPECT_THAT(page.at("text"), HasSubstr("is asked for. ada, cem"));
    EXPECT_THAT(page.at("text"), HasSubstr("Wrong in 2 more programs, but only because of earlier answers."));
}

TEST(ClassReport, ShowsHostileTextAsText) {
    Graded evil = with_name(hostile(), "</td><script>alert(1)</script>", false);
    evil.submission.id = "\"><svg onload=alert(1)>";
    evil.findings.flags = {{"<i>kind</i>", "</article><b>"}};
    const json page = read_page(report_of({evil}));
    EXPECT_THAT(page.at("problems"), IsEmpty()) << page;
    EXPECT_EQ(page.at("rows")[1][0], "</td><script>alert(1)</script>");
    EXPECT_EQ(page.at("rows")[1][1], "\"><svg onload=alert(1)>");
    EXPECT_EQ(page.at("counts").at("script"), 1) << "ours";
    EXPECT_FALSE(page.at("counts").contains("b"));
    EXPECT_FALSE(page.at("counts").contains("i"));
    EXPECT_THAT(page.at("sheets").at("s1"), HasSubstr("<i>kind</i>: </article><b>"));
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

TEST(ClassReport, OfALargeClassLeadsToTheStudentsOwnPagesInsteadOfSheets) {
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

TEST(ClassReport, SaysThatThereWasNoSandbox) {
    std::ostringstream page;
    write_class_report(page, {graded("ada", right_output())}, marking(), Tier::unsafe, page_of_student);
    EXPECT_THAT(read_page(page.str()).at("text"), HasSubstr("Warning. "));
    EXPECT_THAT(read_page(report_of({graded("ada", right_output())})).at("text"), Not(HasSubstr("Warning. ")));
}

}  // namespace
}  // namespace harness::report
