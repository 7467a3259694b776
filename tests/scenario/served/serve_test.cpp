// The self-check page in service: stopped, killed and started again, with hostile programs among honest ones.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <map>
#include <string>

#include "tests/scenario/scenario.h"
#include "tests/scenario/served/serving.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using harness::serve::HttpAnswer;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// Takes a while, then prints the same right answer as the honest program.
constexpr std::string_view slow =
    "#include <cstdio>\n#include <unistd.h>\nint main() { sleep(3); puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, "
    "-1.000000)\"); }\n";

TEST_F(Serving, GradesAnHonestProgramAmongHostileOnes) {
    start({"--limit", "run.cpu_seconds=0.5", "--limit", "run.wall_seconds=5"});
    std::map<std::string, std::string> results;
    for (const char* hostile : {"endless_loop", "fork_bomb", "kill_all", "markup_injection", "ansi_sequences"}) {
        results[hostile] = hand_in(read(project_folder() / "submissions/hostile" / hostile / "ray_cast.cpp"));
    }
    results["honest"] = hand_in(small_program);
    for (const auto& [who, result] : results) EXPECT_EQ(outcome(result).at("standing"), "done") << who;
    EXPECT_EQ(standing(results["honest"]).at("points"), 10);
    const HttpAnswer page = ask(harness::serve::get(results["markup_injection"]));
    EXPECT_EQ(page.status, 200);
    EXPECT_THAT(page.body, AllOf(Not(HasSubstr("<script")), Not(HasSubstr("<img")), Not(HasSubstr("\x1b"))));
    EXPECT_THAT(page.fields.at("content-security-policy"), Not(HasSubstr("script-src")));
    EXPECT_THAT(page.body, HasSubstr("Check another program"));
    EXPECT_THAT(page.body, ContainsRegex("Checked on 20[0-9-]+ at [0-9:]+ [^,<]+, ray_cast.cpp<"));
    const std::string pasted =
        ask("POST /check HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; boundary=cut\r\n"
            "Content-Length: 83\r\n\r\n--cut\r\nContent-Disposition: form-data; name=\"source\"\r\n\r\nint main() { }  "
            "\r\n--cut--\r\n")
            .fields.at("location");
    EXPECT_EQ(outcome("/" + pasted).at("standing"), "done");
    EXPECT_THAT(ask(harness::serve::get("/" + pasted)).body, HasSubstr(", pasted text<"));
    EXPECT_THAT(ask(harness::serve::get(results["endless_loop"])).body,
                AllOf(HasSubstr("Time limit"), HasSubstr("It had not printed a complete line."),
                      Not(HasSubstr("No answer was found")), Not(HasSubstr("Start with question"))));
    const std::string told = read(voice()) + read(output());
    EXPECT_THAT(told, HasSubstr("program 6"));
    for (const auto& [who, result] : results)
        EXPECT_THAT(told, Not(HasSubstr(result.substr(result.rfind('/') + 1))))
            << "whoever reads the log reads results";
}

TEST_F(Serving, LosesNothingWhenKilled) {
    start({"-j", "1"});
    const std::string done = hand_in(small_program);
    EXPECT_EQ(outcome(done).at("points"), 10);
    const std::vector<std::string> results = {hand_in(slow), hand_in(std::string(small_program) + "// other\n")};
    EXPECT_EQ(end(SIGKILL), 128 + SIGKILL);
    start();
    EXPECT_EQ(standing(done).at("points"), 10);
    for (const std::string& result : results) EXPECT_EQ(outcome(result).at("points"), 10) << standing(result);
}

TEST_F(Serving, GivesUpAProgramThatCrashesRaygradeAgainAndAgain) {
    const std::string state = (folder / "kept").string();
    start({"--state", state, "-j", "1"});
    const std::vector<std::string> results = {hand_in(slow), hand_in(small_program)};
    EXPECT_EQ(end(SIGKILL), 128 + SIGKILL);
    SQLite::Database(state + "/spool.sqlite", SQLite::OPEN_READWRITE)
        .exec("UPDATE submissions SET attempts = 3 WHERE number = 1");
    start({"--state", state});
    EXPECT_TRUE(outcome(results[0]).at("points").is_null());
    EXPECT_EQ(outcome(results[1]).at("points"), 10);
    EXPECT_THAT(read(voice()), HasSubstr("crashed raygrade and will not be tried again"));
}

TEST_F(Serving, NeverGradesAQueuedProgramByADifferentAssignment) {
    const std::string state = (folder / "kept").string();
    start({"--state", state, "-j", "1"});
    const std::vector<std::string> results = {hand_in(slow), hand_in(small_program)};
    EXPECT_EQ(end(SIGTERM), 0);
    EXPECT_THAT(read(voice()), HasSubstr("stopped; kept for the next start: 2"));
    const std::string other = (folder / "other.toml").string();
    write(other, read(project_folder() / "reference/assignments/a6-2021.toml") + "\nlate_deduction = 0.5\n");
    const Result refused = raygrade({"serve", "--assignment", other, "--port", "0", "--state", state}, prepare());
    EXPECT_EQ(refused.status, usage) << refused.both();
    EXPECT_THAT(refused.voice, AllOf(HasSubstr("for the assignment a6-2021."), HasSubstr("--state")));
    start({"--state", state});
    for (const std::string& result : results) EXPECT_EQ(outcome(result).at("points"), 10) << standing(result);
    EXPECT_EQ(end(SIGTERM), 0);
    assignment = other;
    start({"--state", state});
    EXPECT_EQ(standing(results.front()).at("points"), 10);
}

TEST_F(Serving, NamesTheAddressesToOpenWhenServingAllAddresses) {
    start({"--host", "0.0.0.0"});
    EXPECT_THAT(read(output()), HasSubstr("From other machines, use an address of this machine in place of 0.0.0.0\n"));
    std::array<char, 256> name{};
    ASSERT_EQ(gethostname(name.data(), name.size() - 1), 0);
    const auto asked_by_name = [&] {
        return ask("GET / HTTP/1.1\r\nHost: " + std::string(name.data()) + "\r\n\r\n").status;
    };
    EXPECT_EQ(asked_by_name(), 421);
    EXPECT_EQ(end(SIGINT), 0);
    start({"--host", "0.0.0.0", "--name", name.data()});
    EXPECT_EQ(asked_by_name(), 200);
    EXPECT_THAT(read(output()), ContainsRegex("  or http://[^/]*/"));
}

TEST_F(Serving, DoesNotStartWithoutAWorkingSandbox) {
    const Result result = raygrade({"serve", "--port", "0", "--sandbox", "bwrap"}, [this] {
        const fs::path bin = folder / "bin";
        fs::create_directories(bin);
        fs::create_symlink("/usr/bin/g++", bin / "g++");
        return prepare()() && setenv("PATH", bin.c_str(), 1) == 0;
    });
    EXPECT_EQ(result.status, 1) << result.both();
    EXPECT_THAT(result.voice, HasSubstr("raygrade doctor"));
    EXPECT_EQ(result.output, "");
}

TEST_F(Serving, SaysWhatIsWrongBeforeItStarts) {
    start();
    const auto voice_of = [&](std::vector<std::string> words, int status) {
        words.insert(words.begin(), "serve");
        const Result result = raygrade(words, prepare());
        EXPECT_EQ(result.status, status) << result.both();
        EXPECT_EQ(result.output, "");
        return result.voice;
    };
    const std::string other = (folder / "other").string();
    EXPECT_THAT(voice_of({"--port", "0"}, 1), AllOf(HasSubstr("--state"), HasSubstr("--port")));
    EXPECT_THAT(voice_of({"--port", "80000", "--state", other}, usage), HasSubstr("65535"));
    EXPECT_THAT(voice_of({"--host", "192.0.2.1", "--state", other}, usage), HasSubstr("0.0.0.0 (all addresses)"));
    EXPECT_THAT(voice_of({"--port", std::to_string(port), "--state", other}, usage), HasSubstr("--port 0"));
    EXPECT_THAT(voice_of({"--host", "example.edu", "--state", other}, usage), HasSubstr("IP address"));
    EXPECT_THAT(voice_of({"--behind-proxy", "--state", other}, usage), HasSubstr("--name"));
    EXPECT_THAT(voice_of({"--name", "http://x/", "--state", other}, usage), HasSubstr("is not a plain host name"));
    EXPECT_THAT(voice_of({"--assignment", "no-such", "--state", other}, usage), HasSubstr("no-such"));
}

}  // namespace
}  // namespace scenario
