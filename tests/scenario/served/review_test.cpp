// An instructor goes through a class with `raygrade review`, and its results follow.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <thread>

#include "tests/given/serve/client.h"
#include "tests/given/serve/hostile_requests.h"
#include "tests/scenario/scenario.h"
#include "tests/scenario/served/answers.h"
#include "tests/scenario/served/attacker.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using harness::serve::HttpAnswer;
using nlohmann::json;
using testing::AllOf;
using testing::AnyOf;
using testing::Ge;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Lt;
using testing::Not;
using testing::SizeIs;

/// Prints question 5 twice: first with these numbers, which are read, and then, in line 6, rightly, for 10 points.
std::string twice(const std::string& numbers, const std::string& title = "Question 6") {
    return "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(" + numbers + ")\\n" + title +
           ":\\na: 1\\nQuestion 5:\\nV: vec3(0.000000, 0.000000, -1.000000)\"); }\n";
}

using Fields = std::vector<std::pair<std::string, std::string>>;

std::string encoded(const Fields& fields) {
    std::string body;
    for (const auto& [name, value] : fields) {
        body += (body.empty() ? "" : "&") + name + "=";
        for (const unsigned char c : value) {
            char hex[4];
            std::snprintf(hex, sizeof hex, "%%%02X", c);
            body += std::isalnum(c) != 0 ? std::string(1, static_cast<char>(c)) : hex;
        }
    }
    return body;
}

class Review : public testing::Test {
  protected:
    Review() {
        fs::permissions(folder.path(), static_cast<fs::perms>(0755));
        fs::create_directories(folder / "run");
        write(student("ada"), twice("0.5, 0, -1"));
        write(student("ben"), twice("0.25, 0, -1"));
        write(student("cy"), twice("0.125, 0, -1", "Sphere of question 6"));
        write(student("dee"), small_program);
        fs::create_directories(folder / "class/eve");
        grade();
        start();
    }
    ~Review() override {
        if (server > 0) end();
    }

    fs::path student(const std::string& id) const { return folder / "class" / id / "ray_cast.cpp"; }
    fs::path out() const { return folder / "out"; }
    Result run(const std::vector<std::string>& words) const {
        return raygrade(words, [this] { return setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1) == 0; });
    }
    Result grade() const { return run({"grade", (folder / "class").string(), "--out", out().string(), "--apply"}); }
    json graded(const std::string& id) const { return submission_in(read_json(out() / "grades.json"), id); }
    double points(const std::string& id) const { return graded(id).at("points").get<double>(); }
    std::string feedback(const std::string& id) const {
        return read(out() / "feedback" / (id + ".md")) + read(out() / "feedback" / (id + ".html"));
    }

    void start() {
        server = fork();
        if (server == 0)
            become_raygrade({"review", out().string(), "--by", "Prof. X"}, {}, folder / "run/out", folder / "run/err");
        const auto late = std::chrono::steady_clock::now() + 60s;
        std::smatch found;
        while (port == 0 && std::chrono::steady_clock::now() < late) {
            std::this_thread::sleep_for(10ms);
            const std::string said = fs::exists(folder / "run/out") ? read(folder / "run/out") : "";
            if (!std::regex_search(said, found, std::regex("Open http://127\\.0\\.0\\.1:(\\d+)(/[0-9a-f]{32})/\n")))
                continue;
            port = static_cast<std::uint16_t>(std::stoi(found[1]));
            root = found[2];
        }
        ASSERT_NE(port, 0) << read(folder / "run/err");
    }
    int end() {
        kill(server, SIGTERM);
        int status = 0;
        waitpid(server, &status, 0);
        server = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

    HttpAnswer get(const std::string& path, const std::string& more = "") const {
        return harness::serve::ask(port, harness::serve::get(path, more));
    }
    std::string list() const { return get(root + "/").body; }
    std::string page(int number) const { return get(root + "/student/" + std::to_string(number)).body; }
    HttpAnswer post(const std::string& path, const Fields& fields, const std::string& more = "") const {
        const std::string body = encoded(fields);
        return harness::serve::ask(port, "POST " + root + path +
                                             " HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
                                             "application/x-www-form-urlencoded\r\n" +
                                             more + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" +
                                             body);
    }
    /// The hidden fields that say which student, in which state.
    static Fields whose(const std::string& page) {
        std::smatch id, state;
        const bool found = std::regex_search(page, id, std::regex("name=\"student\" value=\"([^\"]*)\"")) &&
                           std::regex_search(page, state, std::regex("name=\"state\" value=\"([0-9a-f]{32})\""));
        EXPECT_TRUE(found) << page;
        return found ? Fields{{"student", id[1]}, {"state", state[1]}} : Fields{};
    }
    HttpAnswer decide(const std::string& page, const Fields& more) const {
        Fields fields = whose(page);
        fields.insert(fields.end(), more.begin(), more.end());
        return post("/decide", fields);
    }
    HttpAnswer accept(int number, const std::string& kind = "reading_doubtful") const {
        return decide(page(number), {{"kind", "accepted"}, {"about", kind}, {"for", "one"}});
    }
    HttpAnswer give(const std::string& page, const std::string& item, const std::string& given,
                    const std::string& why = "a <slip>") const {
        return decide(page, {{"kind", "override"}, {"about", item}, {"points", given}, {"text", why}, {"for", "one"}});
    }
    /// The number at the end of the address to which a decision leads.
    static std::string decision(const HttpAnswer& answer) {
        EXPECT_EQ(answer.status, 303) << answer.body;
        const std::string location = answer.status == 303 ? answer.fields.at("location") : "/";
        return location.substr(location.rfind('/') + 1);
    }
    HttpAnswer undo(const std::string& number) const { return post("/undo", {{"number", number}, {"back", "ada"}}); }
    /// What the page before a group's decision offers: the checkboxes' values.
    static std::vector<std::string> offered(const std::string& page) {
        std::vector<std::string> all;
        const std::regex box("name=\"who\" value=\"([^\"]*)\"");
        for (std::sregex_iterator it(page.begin(), page.end(), box), end; it != end; ++it) all.push_back((*it)[1]);
        return all;
    }

    TemporaryFolder folder;
    pid_t server = 0;
    std::uint16_t port = 0;
    std::string root;
};

TEST_F(Review, NamesStudentsAsTheRosterDoesAndInItsOrder) {
    write(folder / "gradebook.csv", "Student,ID,Assignment 6 (71)\r\n\"Roe, Ada\",ada,\r\n\"Abel, Ben\",ben,\r\n");
    const Result regraded = run({"grade", (folder / "class").string(), "--out", out().string(), "--canvas-roster",
                                 (folder / "gradebook.csv").string(), "--apply"});
    const std::string page = list();
    EXPECT_THAT(page, HasSubstr("Roe, Ada (ada)")) << regraded.both();
    EXPECT_LT(page.rfind("Abel, Ben (ben)"), page.rfind("Roe, Ada (ada)"));
    EXPECT_LT(page.find("Abel, Ben (ben)"), page.find("Roe, Ada (ada)"));
}

TEST_F(Review, ListsWhatNeedsAPersonAndAllStudents) {
    const std::string listed = list();
    EXPECT_THAT(listed, AllOf(HasSubstr("<strong>4</strong> of 4 to review"), HasSubstr("Doubtful readings"),
                              HasSubstr("Not graded"), HasSubstr(">dee</a>")));
    EXPECT_LT(listed.find("Doubtful readings"), listed.find("Not graded")) << "the most urgent first";
    EXPECT_THAT(page(1), AllOf(HasSubstr("5.V wrong"), HasSubstr("is this one of"),
                               HasSubstr("<option value=\"5.V\" selected>5.V wrong"),
                               HasSubstr("#include &lt;cstdio&gt;"), HasSubstr("<svg"), HasSubstr("prints 5.V")));
    EXPECT_THAT(page(5), HasSubstr("holds no C++ source"));
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
    EXPECT_THAT(feedback("ada"), Not(HasSubstr("## To look at")));
    EXPECT_THAT(feedback("ben"), HasSubstr("## To look at"));

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
    EXPECT_THAT(undo(number).body, HasSubstr("For ada somebody has changed it since; that stays."));
    EXPECT_THAT(run({"override", "--list", "--results", out().string()}).output, HasSubstr("ada  5.V  3 "));
}

TEST_F(Review, AGroupIsShownBeforeItIsReadAgain) {
    const Fields reading{
        {"kind", "reread"}, {"about", "5.V"}, {"lines", "6"}, {"text", "the last one"}, {"for", "alike"}};
    const std::string shown = decide(page(1), reading).body;
    EXPECT_THAT(shown, AllOf(HasSubstr("5.V stands in line 6: the last one"), HasSubstr("> ada</label>"),
                             HasSubstr("> ben</label>"), HasSubstr("an output with the same layout"),
                             HasSubstr("<td class=\"number\">11.67</td>"), Not(HasSubstr("> cy</label>"))));
    EXPECT_NEAR(points("ada"), 1.67, 0.01) << "nothing is changed yet";

    Fields apply{{"kind", "reread"}, {"about", "5.V"}, {"lines", "6"}, {"text", "the last one"}, {"student", "ada"}};
    for (const std::string& who : offered(shown)) apply.emplace_back("who", who);
    const std::string number = decision(post("/apply", apply));
    EXPECT_NEAR(points("ada"), 11.67, 0.01);
    EXPECT_NEAR(points("ben"), 11.67, 0.01);
    EXPECT_NEAR(points("cy"), 1.67, 0.01);
    EXPECT_THAT(feedback("ben"), HasSubstr("Read from line 6, as Prof. X says: the last one"));
    EXPECT_THAT(grade().both(), HasSubstr("Nothing has changed"));

    EXPECT_EQ(post("/apply", apply).status, 409) << "sent again from the old page";
    EXPECT_THAT(undo(number).body, HasSubstr("Undone: Decision 1: 5.V read again for ada; ben."));
    EXPECT_NEAR(points("ada"), 1.67, 0.01);
    EXPECT_NEAR(points("ben"), 1.67, 0.01);
    EXPECT_THAT(run({"reread", "--list", "--results", out().string()}).output, HasSubstr("no rereads"));
}

TEST_F(Review, PointsForTheSameMistakeAreGivenToThoseChosen) {
    write(student("dee"), "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.5, 0, -1)\"); }\n");
    grade();
    const Fields given{{"kind", "override"}, {"about", "5.V"}, {"points", "4"}, {"text", "half"}};
    Fields ask = given;
    ask.emplace_back("for", "alike");
    const std::vector<std::string> who = offered(decide(page(1), ask).body);
    ASSERT_THAT(who, SizeIs(2)) << "ada and dee printed the same wrong V";
    EXPECT_THAT(decide(page(2), ask).body, HasSubstr("Nobody else has the same mistake in 5.V")) << "ben's is his own";
    Fields apply = given;
    apply.insert(apply.end(), {{"student", "ada"}, {"who", who[1]}});
    decision(post("/apply", apply));
    EXPECT_EQ(points("dee"), 4);
    EXPECT_NEAR(points("ada"), 1.67, 0.01) << "left out";
    apply.pop_back();
    EXPECT_EQ(post("/apply", apply).status, 422) << "nobody is chosen";
}

TEST_F(Review, PointsThatLowerAMarkAreSaidToBeforeAndAfter) {
    write(student("dee"), "#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.5, 0, -1)\"); }\n");
    grade();
    const auto notice = [&](const std::string& given) {
        return get(give(page(1), "5.V", given).fields.at("location")).body;
    };
    EXPECT_THAT(notice("4"), AllOf(HasSubstr("Points for 5.V given for ada."), Not(HasSubstr("It lowers"))));
    EXPECT_THAT(notice("3"), HasSubstr("It lowers question 5, V from 4 to 3 points, and the mark from 5.67 to 4.67."));
    const std::string group =
        decide(page(1), {{"kind", "override"}, {"about", "5.V"}, {"points", "2"}, {"text", "less"}, {"for", "alike"}})
            .body;
    EXPECT_THAT(group,
                AllOf(HasSubstr("It lowers question 5, V from 3 to 2 points"), HasSubstr("<strong>lower</strong>")));
}

TEST_F(Review, PointsForADoubtfulAnswerSettleTheDoubt) {
    Fields given{{"kind", "override"}, {"about", "5.V"}, {"points", "4"}, {"text", "half"}, {"for", "one"}};
    given.emplace_back("accepts", "1");
    const std::string number = decision(decide(page(1), given));
    EXPECT_THAT(list(), HasSubstr("<strong>3</strong> of 4 to review"));
    undo(number);
    EXPECT_THAT(list(), HasSubstr("<strong>4</strong> of 4 to review"));
    EXPECT_NEAR(points("ada"), 1.67, 0.01);
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
    const std::size_t newer = both.find("Points for 5.V given"), older = both.find("Accepted for");
    ASSERT_NE(older, std::string::npos);
    EXPECT_LT(newer, older);
    EXPECT_THAT(both, AllOf(HasSubstr("Prof. X, 20"), HasSubstr("a &lt;slip&gt;"), Not(HasSubstr("a <slip>"))));
    for (const std::string& number : {first, second})
        EXPECT_THAT(both, HasSubstr("name=\"number\" value=\"" + number + "\""));
    EXPECT_EQ(post("/undo", {{"number", first}, {"back", ""}}).status, 200);
    const std::string one_undone = list();
    EXPECT_THAT(one_undone,
                AllOf(HasSubstr("Accepted for"), HasSubstr("Points for 5.V given"), HasSubstr("Undone by Prof. X, 20"),
                      Not(HasSubstr("name=\"number\" value=\"" + first + "\""))))
        << "it stays, but can't be undone again";
    EXPECT_THAT(one_undone, HasSubstr("name=\"number\" value=\"" + second + "\""));
}

TEST_F(Review, WhatACommandDidCanBeTakenBack) {
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

TEST_F(Review, AChangeOnAnOldStateIsRefused) {
    const std::string first = page(1), second = page(1), other = page(2);
    decision(give(first, "5.V", "7"));
    const double now = points("ada");
    const HttpAnswer late = give(second, "5.V", "3", "from the other window");
    EXPECT_EQ(late.status, 409);
    EXPECT_THAT(late.body, AllOf(HasSubstr("ada changed since this page was made, so nothing was done"),
                                 HasSubstr("7 points for question 5, V"), HasSubstr("from the other window")))
        << "with the new state, and what was typed";
    EXPECT_EQ(points("ada"), now);
    EXPECT_EQ(give(late.body, "5.V", "3").status, 303) << "decided again on the new state";
    EXPECT_EQ(give(other, "5.V", "2").status, 303) << "a change to ada is none to ben";

    const std::string before = page(1);
    run({"override", "ada", "total", "50", "--why", "x", "--results", out().string()});
    EXPECT_EQ(give(before, "5.V", "3").status, 409) << "a command changed it";
    EXPECT_EQ(points("ada"), 50);
    const std::string graded_before = page(2);
    write(student("ben"), twice("0.3, 0, -1"));
    grade();
    EXPECT_EQ(give(graded_before, "5.V", "3").status, 409) << "it was graded again";
}

TEST_F(Review, AFolderInUseIsSaid) {
    const std::string shown = page(1);
    const int opened = open(out().c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(flock(opened, LOCK_EX), 0);
    const HttpAnswer busy = give(shown, "5.V", "3", "typed");
    EXPECT_EQ(busy.status, 422);
    EXPECT_THAT(busy.body, AllOf(HasSubstr("another raygrade"), HasSubstr("value=\"typed\"")));
    EXPECT_THAT(page(1), HasSubstr("Printout")) << "it can still be read";
    close(opened);
    EXPECT_EQ(give(shown, "5.V", "3").status, 303);
}

TEST_F(Review, SaysWhatCanNotBeDoneAndKeepsWhatWasTyped) {
    const auto refused = [&](const Fields& fields) {
        const HttpAnswer answer = decide(page(1), fields);
        EXPECT_EQ(answer.status, 422);
        return answer.body;
    };
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "5.V"}, {"points", "ten"}, {"text", "\"why\""}}),
                AllOf(HasSubstr("ten: is no number of points"), HasSubstr("value=\"&quot;why&quot;\"")));
    EXPECT_THAT(
        refused({{"kind", "override"}, {"about", "6.a"}, {"points", "ten"}, {"text", "x"}}),
        AllOf(HasSubstr("<option value=\"6.a\" selected>6.a:"), HasSubstr("<option value=\"6.a\" selected>6.a ")))
        << "the forms and the source stay at the item";
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "5.V"}, {"points", "1"}, {"text", " "}}),
                HasSubstr("the reason: is blank"));
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "5.W"}, {"points", "1"}, {"text", "x"}}),
                HasSubstr("5.W: is no item"));
    EXPECT_THAT(refused({{"kind", "reread"}, {"about", "5.V"}, {"lines", "4"}, {"text", "x"}}),
                HasSubstr("line 4 holds 1 number"));
    EXPECT_THAT(refused({{"kind", "reread"}, {"about", "5.V"}, {"lines", ""}, {"text", "x"}}),
                HasSubstr("say that it was not printed"));
    EXPECT_THAT(refused({{"kind", "accepted"}, {"about", "hard_coded"}}), HasSubstr("nothing of this kind to accept"));
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "5.V"}, {"points", "1"}, {"text", "x"}, {"for", "alike"}}),
                HasSubstr("Nobody else has the same mistake in 5.V"));
    EXPECT_THAT(refused({{"kind", "else"}}), HasSubstr("not one of the review"));
    EXPECT_NEAR(points("ada"), 1.67, 0.01);
}

TEST_F(Review, AnswersOnlyWhoKnowsTheSecretAndIsHere) {
    const std::string wrong = root.substr(0, root.size() - 1) + (root.back() == '0' ? '1' : '0');
    for (const std::string& path : {std::string("/"), wrong + "/", root + "x/", wrong + "/student/1",
                                    std::string("/style.css"), root.substr(0, 20)}) {
        EXPECT_EQ(get(path).status, 404) << path;
        EXPECT_THAT(get(path).body, Not(HasSubstr("ada"))) << path;
    }
    const auto from = [&](const std::string& host) {
        return harness::serve::ask(port, "GET " + root + "/ HTTP/1.1\r\nHost: " + host + "\r\n\r\n").status;
    };
    EXPECT_EQ(from("localhost"), 200);
    EXPECT_EQ(from("127.0.0.1:" + std::to_string(port)), 200);
    EXPECT_EQ(from("rebound.example"), 421);
    EXPECT_EQ(from("192.168.1.20"), 421);

    Fields fields = whose(page(1));
    fields.insert(fields.end(), {{"kind", "override"}, {"about", "5.V"}, {"points", "1"}, {"text", "x"}});
    EXPECT_EQ(post("/decide", fields, "Origin: http://elsewhere.example\r\n").status, 403);
    EXPECT_EQ(post("/decide", fields, "Sec-Fetch-Site: cross-site\r\n").status, 403);
    EXPECT_EQ(get(root + "/decide").status, 405);
    EXPECT_NEAR(points("ada"), 1.67, 0.01);
    const HttpAnswer shown = get(root + "/student/1");
    EXPECT_THAT(shown.fields.at("content-security-policy"),
                AllOf(HasSubstr("default-src 'none'"), HasSubstr("script-src 'self'"), HasSubstr("form-action 'self'"),
                      Not(HasSubstr("unsafe"))));
    EXPECT_EQ(post("/decide", fields, "Origin: http://localhost\r\n").status, 303);
}

TEST_F(Review, ShowsHostileTextAsText) {
    const std::string attack = "</span></pre><script>alert(1)</script><b title='";
    const std::string program = "#include <cstdio>\n// " + attack + "\nint main() { puts(\"Question 5:\\nV: " + attack +
                                " 1 2 3\\nQuestion 6:\\na: 1\\nQuestion 5:\\nV: 0 0 -1\"); }\n";
    write(student("ada"), program);
    write(student("ben"), program);
    fs::create_directories(folder / "class/<b title='x'>");  // not graded, for a reason that names it
    grade();
    const std::vector<std::string> pages{
        list(),
        page(1),
        page(2),
        give(page(2), "5.V", attack, attack).body,
        decide(page(2), {{"kind", "comment"}, {"text", attack}, {"for", "alike"}}).body,
        decide(page(2), {{"kind", "accepted"}, {"about", "reading_doubtful"}, {"for", "alike"}}).body};
    for (const std::string& shown : pages)
        EXPECT_THAT(shown, AllOf(Not(HasSubstr("<script>alert")), Not(HasSubstr("<b title"))));
    EXPECT_THAT(pages[0], HasSubstr("&lt;b title=&#39;x&#39;&gt;"));
    EXPECT_THAT(pages[2], HasSubstr("&lt;script&gt;alert(1)"));
    EXPECT_THAT(pages[4], AllOf(HasSubstr("For whom?"), HasSubstr("&lt;script&gt;alert(1)")));
    EXPECT_THAT(pages[5], HasSubstr("For whom?"));
}

TEST_F(Review, RefusesAndTellsNothingToWhoDoesNotKnowItsAddress) {
    const fs::path planted = folder / "planted";
    write(planted, "planted-" + root + "\n");
    std::string wrong = root;
    wrong.back() = wrong.back() == '0' ? '1' : '0';
    // The corpus of attacks on the self-check page, at an address that is wrong in one digit.
    const harness::serve::Target target{"localhost", wrong + "/student/1", planted.string(),
                                        std::string(small_program)};
    const std::vector<std::string> secrets{root.substr(1), "planted-", "SQLite format 3", out().string(), ">dee<"};
    const std::string before = list();
    for (std::uint32_t seed = 0; seed < 6 * harness::serve::hostile_request_kinds(); ++seed) {
        const auto attack = harness::serve::hostile_request(seed, target);
        const std::string received = exchange(port, 3, attack.bytes, 15s);
        EXPECT_EQ(told(received, secrets), "") << attack.what << ", seed " << seed;
        for (const Answer& answer : answers_in(received, attack.is_to_head).all) {
            EXPECT_THAT(answer.status, AnyOf(AllOf(Ge(400), Lt(500)), 100, 501, 505))
                << attack.what << ", seed " << seed;
            EXPECT_EQ(wrong_with(answer), "") << attack.what << ", seed " << seed;
        }
    }
    EXPECT_EQ(list(), before) << "nothing is decided";
    EXPECT_THAT(read(folder / "run/err"), IsEmpty());
    EXPECT_EQ(end(), 0);
}

TEST(ReviewCommand, NeedsResults) {
    const TemporaryFolder folder;
    const Result result = raygrade({"review", (folder / "none").string()});
    EXPECT_EQ(result.status, usage);
    EXPECT_THAT(result.voice, HasSubstr("holds no gradebook"));
}

}  // namespace
}  // namespace scenario
