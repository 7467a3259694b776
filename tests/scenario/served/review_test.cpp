// What an instructor decides on the pages of the review, and undo.
#include "tests/scenario/served/review.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/given/serve/client.h"
#include "tests/scenario/scenario.h"
#include "tests/scenario/served/answers.h"

namespace scenario {
namespace {

using harness::serve::HttpAnswer;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

TEST_F(Review, NamesStudentsAsTheRosterDoesAndInItsOrder) {
    write(folder / "gradebook.csv", "Student,ID,Assignment 6 (71)\r\n\"Roe, Ada\",ada,\r\n\"Abel, Ben\",ben,\r\n");
    const Result regraded = run({"grade", (folder / "class").string(), "--out", out().string(), "--canvas-roster",
                                 (folder / "gradebook.csv").string(), "--apply"});
    const std::string page = list();
    EXPECT_THAT(page, HasSubstr("Roe, Ada (ada)")) << regraded.both();
    EXPECT_LT(page.rfind("Abel, Ben (ben)"), page.rfind("Roe, Ada (ada)"));
    EXPECT_LT(page.find("Abel, Ben (ben)"), page.find("Roe, Ada (ada)"));
}

TEST_F(Review, ListsDoubtfulAnswersFlagsAndAllStudents) {
    const std::string listed = list();
    EXPECT_THAT(listed, AllOf(HasSubstr("<strong>4</strong> of 4 to review"), HasSubstr("Doubtful readings"),
                              HasSubstr("Not graded"), HasSubstr(">dee</a>")));
    EXPECT_LT(listed.find("Doubtful readings"), listed.find("Not graded")) << "the most urgent first";
    EXPECT_THAT(page(1), AllOf(HasSubstr("question 5, V: wrong"), HasSubstr("is this one of"),
                               HasSubstr("<option value=\"5.V\" selected>question 5, V: wrong"),
                               HasSubstr("#include &lt;cstdio&gt;"), HasSubstr("<svg"), HasSubstr("prints 5.V")));
    EXPECT_THAT(page(5), HasSubstr("There is no file. Hand in one file named ray_cast.cpp."));
    EXPECT_EQ(get(root + "/student/6").status, 404);
    EXPECT_THAT(read(folder / "run/out"), HasSubstr("4 of 5 to review"));
    EXPECT_THAT(read(folder / "run/err"), IsEmpty());
    EXPECT_EQ(end(), 0);
}

TEST_F(Review, ACaseOfSeveralShowsEachReasonWithItsStudents) {
    write(student("fay"), twice("0.125, 0, -1", "Sphere of question 6"));
    const auto constants = [](const std::string& t) {
        return "#include <cstdio>\nint main() { puts(\"Question 6:\\na: 1.5432\\nb: 2.5432\\nt: " + t + "\"); }\n";
    };
    write(student("gus"), constants("1.2345"));
    write(student("hal"), constants("2.3456"));
    grade();
    const std::string page = list();
    EXPECT_THAT(page, AllOf(HasSubstr("1.2345"), HasSubstr("2.3456"), HasSubstr("<strong>gus:</strong>"),
                            HasSubstr("<strong>hal:</strong>")));
    EXPECT_THAT(page, Not(HasSubstr("<strong>cy"))) << "cy and fay have one reason";
}

TEST_F(Review, AnAcceptedDoubtStaysAcceptedWhileItIsTheSame) {
    ASSERT_THAT(graded("ada").at("flags"), SizeIs(1));
    const HttpAnswer accepted = accept(1);
    EXPECT_THAT(accepted.fields.at("location"), HasSubstr("/student/2/done/")) << "on to the next";
    const std::string listed = list();
    EXPECT_THAT(listed, HasSubstr("<strong>3</strong> of 4 to review"));
    const std::size_t chapter = listed.find("Doubtful readings");
    EXPECT_THAT(listed.substr(chapter, listed.find("Not graded") - chapter),
                AllOf(HasSubstr(">ben<"), Not(HasSubstr(">ada<"))));
    const auto by = [&] { return graded("ada").at("flags").at(0).value("accepted", json::object()).value("by", ""); };
    EXPECT_EQ(by(), "Prof. X");
    EXPECT_THAT(feedback("ada"), Not(HasSubstr("raygrade may have misread some answers")));
    EXPECT_THAT(feedback("ben"), HasSubstr("raygrade may have misread some answers"));

    EXPECT_THAT(grade().both(), HasSubstr("Nothing has changed"));
    write(student("ada"), twice("0.5, 0, -1") + "// again\n");
    grade();
    EXPECT_EQ(by(), "Prof. X") << "another source that prints the same";
    EXPECT_THAT(list(), HasSubstr("<strong>3</strong> of 4 to review"));
    write(student("ada"), twice("0.75, 0, -1"));
    grade();
    EXPECT_EQ(by(), "") << "another answer was read";
    EXPECT_THAT(list(), HasSubstr("<strong>4</strong> of 4 to review"));
}

TEST_F(Review, GivesPointsAsOverrideDoesAndUndoGivesTheEarlierOnesBack) {
    ASSERT_EQ(
        run({"override", "ada", "5.V", "2.5", "--why", "first", "--by", "Ann", "--results", out().string()}).status, 0);
    const double before = points("ada");
    const std::string number = decision(give(page(1), "5.V", "7"));
    EXPECT_NEAR(points("ada"), before + 4.5, 1e-9);
    const std::string listed = run({"override", "--list", "--results", out().string()}).output;
    EXPECT_THAT(listed, AllOf(HasSubstr("ada  5.V  7 (of 10, automatically 0)  by Prof. X"), HasSubstr("a <slip>"),
                              Not(HasSubstr("first"))));
    EXPECT_THAT(feedback("ada"), HasSubstr("a &lt;slip&gt;"));
    EXPECT_THAT(page(1), AllOf(HasSubstr("a &lt;slip&gt;"), Not(HasSubstr("<slip>"))));

    EXPECT_EQ(undo(number).status, 200);
    EXPECT_NEAR(points("ada"), before, 1e-9);
    EXPECT_THAT(run({"override", "--list", "--results", out().string()}).output, HasSubstr("by Ann"));
    EXPECT_EQ(undo(number).status, 422) << "once";
    EXPECT_NEAR(points("ada"), before, 1e-9);
    EXPECT_THAT(grade().both(), HasSubstr("Nothing has changed"));
}

TEST_F(Review, UndoLeavesWhatSomebodyChangedSince) {
    const std::string number = decision(give(page(1), "5.V", "7"));
    ASSERT_EQ(run({"override", "ada", "5.V", "3", "--why", "later", "--by", "Ann", "--results", out().string()}).status,
              0);
    EXPECT_THAT(undo(number).body, HasSubstr("It stays for ada, because somebody has changed it since."));
    EXPECT_THAT(run({"override", "--list", "--results", out().string()}).output, HasSubstr("ada  5.V  3 "));
}

TEST_F(Review, PointsForTheSameMistakeAreGivenToTheSelectedStudents) {
    write(student("dee"), "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.5, 0, -1)\"); }\n");
    grade();
    const Fields given{{"kind", "override"}, {"about", "5.V"}, {"points", "4"}, {"text", "half"}};
    Fields ask = given;
    ask.emplace_back("for", "alike");
    const std::vector<std::string> who = offered(decide(page(1), ask).body);
    ASSERT_THAT(who, SizeIs(2)) << "ada and dee printed the same wrong V";
    EXPECT_THAT(decide(page(2), ask).body, HasSubstr("No other student has the same mistake in question 5, V"))
        << "ben's is his own";
    Fields apply = given;
    apply.insert(apply.end(), {{"student", "ada"}, {"who", who[1]}});
    decision(post("/apply", apply));
    EXPECT_EQ(points("dee"), 4);
    EXPECT_NEAR(points("ada"), 1.67, 0.01) << "left out";
    apply.pop_back();
    EXPECT_EQ(post("/apply", apply).status, 422) << "nobody is chosen";
}

TEST_F(Review, PointsThatLowerAMarkAreReportedBeforeAndAfter) {
    write(student("dee"), "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.5, 0, -1)\"); }\n");
    grade();
    const auto notice = [&](const std::string& given) {
        return get(give(page(1), "5.V", given).fields.at("location")).body;
    };
    EXPECT_THAT(notice("4"), AllOf(HasSubstr("Points given (question 5, V) for ada."), Not(HasSubstr("It lowers"))));
    EXPECT_THAT(notice("3"), HasSubstr("It lowers question 5, V from 4 to 3 points, and the mark from 5.67 to 4.67."));
    const std::string group =
        decide(page(1), {{"kind", "override"}, {"about", "5.V"}, {"points", "2"}, {"text", "less"}, {"for", "alike"}})
            .body;
    EXPECT_THAT(group,
                AllOf(HasSubstr("It lowers question 5, V from 3 to 2 points"), HasSubstr("<strong>lower</strong>")));
}

TEST_F(Review, ACommentIsInTheFeedbackUntilItIsTakenBack) {
    decision(decide(page(1), {{"kind", "comment"}, {"about", "5.V"}, {"text", "Print <it>\r\nonce."}, {"for", "one"}}));
    EXPECT_THAT(feedback("ada"), AllOf(HasSubstr("Your instructor writes about question 5, V: Print &lt;it&gt; once."),
                                       HasSubstr("Print <it> once.")))
        << "on the page and in Markdown";
    EXPECT_EQ(graded("ada").at("comments").at(0).at("text"), "Print <it> once.");
    decision(decide(page(5), {{"kind", "comment"}, {"about", ""}, {"text", "Hand in."}, {"for", "one"}}));
    EXPECT_THAT(feedback("eve"), HasSubstr("Your instructor writes: ")) << "also where nothing was graded";
    EXPECT_THAT(grade().both(), HasSubstr("Nothing has changed"));

    Fields back = whose(page(1));
    back.insert(back.end(), {{"what", "decision"}, {"about", "1"}});
    EXPECT_EQ(post("/take-back", back).status, 303);
    EXPECT_THAT(feedback("ada"), Not(HasSubstr("Your instructor writes")));
    EXPECT_THAT(feedback("eve"), HasSubstr("Your instructor writes"));
    EXPECT_EQ(post("/take-back", back).status, 409);
}

TEST_F(Review, ListsTheDecisionsNewestFirstEachWithItsUndoOrWhoUndidIt) {
    EXPECT_THAT(list(), Not(HasSubstr("<h2 id=\"past\">")));
    const std::string first = decision(accept(1));
    const std::string second = decision(give(page(2), "5.V", "3"));
    const std::string both = list();
    const std::size_t newer = both.find("Points given (question 5, V)"), older = both.find("Accepted for");
    ASSERT_NE(older, std::string::npos);
    EXPECT_LT(newer, older);
    EXPECT_THAT(both, AllOf(HasSubstr("Prof. X, <time datetime=\"20"), HasSubstr("a &lt;slip&gt;"),
                            Not(HasSubstr("a <slip>"))));
    for (const std::string& number : {first, second})
        EXPECT_THAT(both, HasSubstr("name=\"number\" value=\"" + number + "\""));
    EXPECT_EQ(post("/undo", {{"number", first}, {"back", ""}}).status, 200);
    const std::string one_undone = list();
    EXPECT_THAT(one_undone, AllOf(HasSubstr("Accepted for"), HasSubstr("Points given (question 5, V)"),
                                  HasSubstr("Undone by Prof. X, <time datetime=\"20"),
                                  Not(HasSubstr("name=\"number\" value=\"" + first + "\""))))
        << "it stays, but can't be undone again";
    EXPECT_THAT(one_undone, HasSubstr("name=\"number\" value=\"" + second + "\""));
}

TEST_F(Review, TheDecisionOfACommandCanBeTakenBack) {
    run({"override", "ada", "total", "50", "--why", "x", "--results", out().string()});
    run({"reread", "ben", "5.V", "6", "--why", "x", "--results", out().string()});
    Fields total = whose(page(1)), reading = whose(page(2));
    total.insert(total.end(), {{"what", "override"}, {"about", "total"}});
    reading.insert(reading.end(), {{"what", "reread"}, {"about", "5.V"}});
    EXPECT_EQ(post("/take-back", total).status, 303);
    EXPECT_EQ(post("/take-back", reading).status, 303);
    EXPECT_NEAR(points("ada"), 1.67, 0.01);
    EXPECT_NEAR(points("ben"), 1.67, 0.01);
}

}  // namespace
}  // namespace scenario
