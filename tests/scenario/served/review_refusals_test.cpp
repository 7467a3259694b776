// What the review refuses: strangers, hostile text, changes on an old state.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/given/serve/client.h"
#include "tests/given/serve/hostile_requests.h"
#include "tests/scenario/scenario.h"
#include "tests/scenario/served/answers.h"
#include "tests/scenario/served/review.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using harness::serve::HttpAnswer;
using testing::AllOf;
using testing::AnyOf;
using testing::Ge;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Lt;
using testing::Not;

TEST_F(Review, AChangeOnAnOldStateIsRefused) {
    const std::string first = page(1), second = page(1), other = page(2);
    decision(give(first, "5.V", "7"));
    const double now = points("ada");
    const HttpAnswer late = give(second, "5.V", "3", "from the other window");
    EXPECT_EQ(late.status, 409);
    EXPECT_THAT(late.body, AllOf(HasSubstr("ada changed since this page was loaded, so nothing was done"),
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

TEST_F(Review, AFolderInUseIsReported) {
    const std::string shown = page(1);
    const int opened = open(out().c_str(), O_RDONLY | O_DIRECTORY);
    ASSERT_EQ(flock(opened, LOCK_EX), 0);
    const HttpAnswer busy = give(shown, "5.V", "3", "typed");
    EXPECT_EQ(busy.status, 422);
    EXPECT_THAT(busy.body, AllOf(HasSubstr("another raygrade"), HasSubstr("value=\"typed\"")));
    EXPECT_THAT(page(1), HasSubstr("Output")) << "it can still be read";
    close(opened);
    EXPECT_EQ(give(shown, "5.V", "3").status, 303);
}

TEST_F(Review, ExplainsARefusalAndKeepsTheTypedText) {
    const auto refused = [&](const Fields& fields) {
        const HttpAnswer answer = decide(page(1), fields);
        EXPECT_EQ(answer.status, 422);
        return answer.body;
    };
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "5.V"}, {"points", "ten"}, {"text", "\"why\""}}),
                AllOf(HasSubstr("&quot;ten&quot; is not a number of points"), HasSubstr("value=\"&quot;why&quot;\"")));
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "6.a"}, {"points", "ten"}, {"text", "x"}}),
                AllOf(HasSubstr("<option value=\"6.a\" selected>question 6, a: 1.67 of 1.67"),
                      HasSubstr("<option value=\"6.a\" selected>question 6, a: right")))
        << "the forms and the source stay at the item";
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "5.V"}, {"points", "1"}, {"text", " "}}),
                HasSubstr("the reason is empty"));
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "5.W"}, {"points", "1"}, {"text", "x"}}),
                HasSubstr("there is no item &quot;5.W&quot;"));
    EXPECT_THAT(refused({{"kind", "reread"}, {"about", "5.V"}, {"lines", "4"}, {"text", "x"}}),
                HasSubstr("line 4 has 1 number"));
    EXPECT_THAT(refused({{"kind", "reread"}, {"about", "5.V"}, {"lines", ""}, {"text", "x"}}),
                HasSubstr("check &quot;not printed&quot;"));
    EXPECT_THAT(refused({{"kind", "accepted"}, {"about", "hard_coded"}}), HasSubstr("no longer has this flag"));
    EXPECT_THAT(refused({{"kind", "override"}, {"about", "5.V"}, {"points", "1"}, {"text", "x"}, {"for", "alike"}}),
                HasSubstr("No other student has the same mistake in question 5, V"));
    EXPECT_THAT(refused({{"kind", "else"}}), HasSubstr("form is unknown"));
    EXPECT_NEAR(points("ada"), 1.67, 0.01);
}

TEST_F(Review, AnswersOnlyThisMachineAndOnlyWithTheSecret) {
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

TEST_F(Review, RevealsNothingToARequestWithoutItsAddress) {
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
        const std::string received = harness::serve::exchange(port, attack.bytes);
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
    EXPECT_THAT(pages[4], AllOf(HasSubstr("Which students?"), HasSubstr("&lt;script&gt;alert(1)")));
    EXPECT_THAT(pages[5], HasSubstr("Which students?"));
}

}  // namespace
}  // namespace scenario
