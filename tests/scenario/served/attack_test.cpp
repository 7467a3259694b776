// Whatever clients send to the self-check page, honest students get their marks in time, and nobody gets anything else.
#include "tests/given/serve/attack.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <future>
#include <iostream>
#include <iterator>
#include <thread>

#include "tests/scenario/served/answers.h"
#include "tests/scenario/served/serving.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using harness::serve::HostileRequest;
using harness::serve::Target;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// For one answer, on a busy machine.
constexpr auto time_of_an_answer = 15s;

/// A server that answers nothing any more would else take hours.
constexpr unsigned enough_failures = 10;

struct Student {
    std::string source;
    std::string file;  ///< its name, which is nobody else's
    double points;
};

/// Prints an answer that is right or wrong. The number makes the source one that was never seen.
Student student(unsigned number, bool is_right) {
    const std::string mark = std::to_string(number) + (is_right ? "right" : "wrong");
    return {"#include <cstdio>\nint main() { puts(\"Question 5:\\nV: vec3(0.000000, 0.000000, " +
                std::string(is_right ? "-1.000000" : "0.500000") + ")\"); }  // " + mark + "\n",
            "student" + mark + ".cpp", is_right ? 10.0 : 0.0};
}

std::size_t open_files(pid_t process) {
    const fs::directory_iterator all("/proc/" + std::to_string(process) + "/fd");
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

class UnderAttack : public Serving {
  protected:
    UnderAttack() { write(planted(), "planted-" + secret + "\n"); }

    fs::path planted() const { return folder / "state/planted"; }

    void begin(const std::string& host, const std::vector<std::string>& more = {}) {
        const Preparation with_secret = [this] { return setenv("RAYGRADE_PLANTED", secret.c_str(), 1) == 0; };
        start(more, with_secret);
        target.host = host;
        target.planted = planted().string();
        // The compiler's message is shown, too.
        target.program = "#error " + harness::serve::hostile_markup + "\x1b[2J\n";
        secrets = {secret, "SQLite format 3", "root:x:0:0", (folder / "state").string()};
        ask_for_marks(student(0, false), &target.result);
        ask_for_marks({target.program, "x.cpp", 0}, nullptr);
        before = open_files(server);
    }

    /// Asks as a browser does, and says which request went wrong.
    std::string asked(const Student& who, const std::string& request, int status) const {
        const auto begin = Clock::now();
        const auto answers = answers_in(harness::serve::exchange(port, request), false);
        const std::string what = who.file + ", " + request.substr(0, request.find('\r')) + ": ";
        if (answers.all.size() != 1 || answers.all[0].status != status) {
            throw std::runtime_error(what + (answers.all.empty()
                                                 ? "no answer " + answers.problem
                                                 : std::to_string(answers.all[0].status) + " " + answers.all[0].body));
        }
        if (Clock::now() - begin > time_of_an_answer) throw std::runtime_error(what + "too late");
        if (const std::string wrong = wrong_with(answers.all[0]); !wrong.empty())
            throw std::runtime_error(what + wrong);
        return answers.all[0].fields.contains("location") ? answers.all[0].fields.at("location") : answers.all[0].body;
    }

    /// Hands in a program and reads its page, as a student does. Throws std::runtime_error if anything is not as it
    /// should be. The address and the name are secrets from then on.
    void ask_for_marks(const Student& who, std::string* keep) {
        using harness::serve::head;
        asked(who, head("GET", "/", target), 200);
        Target own = target;
        own.program = who.source;
        const std::string result =
            std::string("/").append(asked(who, harness::serve::upload_to(own, "", who.file), 303));
        asked(who, head("GET", result, target), 200);
        json now;
        for (const auto late = Clock::now() + patience; Clock::now() < late; std::this_thread::sleep_for(50ms)) {
            now = json::parse(asked(who, head("GET", result + "/standing", target), 200));
            if (now.at("standing") != "waiting" && now.at("standing") != "grading") break;
        }
        if (now.at("standing") != "done" || now.at("points") != who.points)
            throw std::runtime_error(who.file + " has the marks " + now.dump());
        const std::string page = asked(who, head("GET", result, target), 200);
        if (page.find(", " + who.file + "<") == std::string::npos)
            throw std::runtime_error(who.file + " has a page of others");
        const std::lock_guard lock(mutex);
        for (const std::string& other : names) {
            if (other != who.file && page.find(other) != std::string::npos)
                throw std::runtime_error(who.file + " sees " + other);
        }
        names.push_back(who.file);
        if (keep == nullptr) return;
        *keep = result;
        secrets.push_back(who.file);
        secrets.push_back(result.substr(result.rfind('/') + 1));
    }

    /// What went wrong; empty if nothing did.
    std::string visit(const Student& who) {
        try {
            ask_for_marks(who, nullptr);
            return "";
        } catch (const std::exception& error) {
            return error.what();
        }
    }

    /// Sends the attack, and returns what went wrong.
    std::string attack(const HostileRequest& request) {
        try {
            if (request.resets) {
                harness::serve::Client client(port);
                client.send(request.bytes);
                client.reset();
                return "";
            }
            const std::string received = harness::serve::exchange(port, request.bytes);
            if (std::string wrong = wrong_with(received, request, secrets); !wrong.empty()) return wrong;
            if (!request.is_upload || request.is_damaged) return "";
            for (const Answer& answer : answers_in(received, false).all) {
                if (answer.fields.contains("location")) uploaded.push_back("/" + answer.fields.at("location"));
            }
            return "";
        } catch (const std::exception& error) {
            return error.what();
        }
    }

    /// The pages of the attacker's programs show everything hostile as text.
    void read_uploaded() {
        const Student who{"", "the attacker", 0};
        for (const std::string& result : uploaded) {
            EXPECT_EQ(outcome_of(who, result), "done") << result;
            const std::string page = asked(who, harness::serve::head("GET", result, target), 200);
            EXPECT_EQ(told(page, secrets), "");
            EXPECT_THAT(page, HasSubstr("&lt;script&gt;x7351()"));
        }
        uploaded.clear();
    }
    std::string outcome_of(const Student& who, const std::string& result) {
        json now;
        for (const auto late = Clock::now() + patience; Clock::now() < late; std::this_thread::sleep_for(20ms)) {
            now = json::parse(asked(who, harness::serve::head("GET", result + "/standing", target), 200));
            if (now.at("standing") != "waiting" && now.at("standing") != "grading") break;
        }
        return now.at("standing");
    }

    bool lives() const { return waitpid(server, nullptr, WNOHANG) == 0; }

    /// Attacks number `first` to `last`, while two students are there.
    void round(unsigned first, unsigned last) {
        auto right = std::async(std::launch::async, [&] { return visit(student(last, true)); });
        auto wrong = std::async(std::launch::async, [&] { return visit(student(last, false)); });
        for (unsigned seed = first; seed < last; ++seed) {
            const HostileRequest request = harness::serve::hostile_request(seed, target);
            const std::string failure = attack(request);
            EXPECT_EQ(failure, "") << request.what << ", seed " << seed << ":\n" << request.bytes.substr(0, 1000);
            ASSERT_TRUE(lives()) << "seed " << seed;
            failures += failure.empty() ? 0 : 1;
            ASSERT_LT(failures, enough_failures);
        }
        EXPECT_EQ(right.get(), "") << "seed " << first;
        EXPECT_EQ(wrong.get(), "") << "seed " << first;
        ASSERT_TRUE(lives());
        read_uploaded();
        expect_no_open_connections();
    }

    void expect_no_open_connections() {
        const auto late = Clock::now() + time_of_an_answer;
        while (open_files(server) > before + 5 && Clock::now() < late) std::this_thread::sleep_for(20ms);
        EXPECT_LE(open_files(server), before + 5) << "of connections that are gone";
    }

    /// The whole of a test: rounds of attacks until `count` are done.
    void attack_in_rounds(unsigned count) {
        const unsigned kinds = harness::serve::hostile_request_kinds();
        const unsigned a_round = 9 * kinds;
        unsigned done = 0;
        for (; done < count && !HasFatalFailure(); done += a_round) round(done, std::min(done + a_round, count));
        std::cout << count << " attacks of " << kinds << " kinds\n";
        if (HasFatalFailure()) return;
        const std::string said = read(voice()) + read(output());
        EXPECT_THAT(said, Not(HasSubstr("internal error")));
        EXPECT_EQ(told(said, secrets), "") << "in the log";
        EXPECT_EQ(end(SIGTERM), 0) << read(voice());
    }

    const std::string secret = "b9d1f1c4-nobody-may-read-this";
    Target target;
    std::vector<std::string> secrets;
    std::vector<std::string> names;
    std::vector<std::string> uploaded;  ///< results of the attacker
    std::size_t before = 0;             ///< open files
    unsigned failures = 0;
    std::mutex mutex;  ///< guards names and secrets
};

unsigned attacks(unsigned few) {
    const char* const wanted = std::getenv("RAYGRADE_ATTACKS");
    return wanted == nullptr ? few * harness::serve::hostile_request_kinds() : static_cast<unsigned>(std::atoi(wanted));
}

TEST_F(UnderAttack, GivesHonestStudentsTheirMarksAndNobodyAnythingElse) {
    begin("localhost");
    attack_in_rounds(attacks(6));
}

TEST_F(UnderAttack, GivesHonestStudentsTheirMarksBehindAProxyToo) {
    begin("check.example.edu", {"--behind-proxy", "--name", "check.example.edu"});
    attack_in_rounds(attacks(3));
}

}  // namespace
}  // namespace scenario
