// Runs every program of submissions/hostile in every tier of the sandbox. Checks its outcome, and that it harms neither
// the submission graded next to it, nor the machine, nor the reports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>

#include "harness/grade/batch.h"
#include "harness/intake/intake.h"
#include "harness/machine/errors.h"
#include "harness/record/marking.h"
#include "harness/report/data/grades_csv.h"
#include "harness/report/data/grades_json.h"
#include "harness/report/text/class_table.h"
#include "harness/report/text/feedback.h"
#include "harness/run/run.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"
#include "harness/sandbox/host/canary.h"
#include "harness/sandbox/host/scratch.h"
#include "tests/scenario/hostile/corpus.h"
#include "tests/scenario/hostile/decoys.h"

namespace hostile {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using harness::Graded;
using harness::Runner;
using harness::Submission;
using harness::Tier;

const fs::path project = RAYGRADE_PROJECT;

struct TestedTier {
    Tier tier;
    const char* name;
};
constexpr std::array<TestedTier, 2> tiers = {{{Tier::bwrap, "bwrap"}, {Tier::landlock, "landlock"}}};

/// Why the tier cannot start any program on this machine; "" if it can. A tier that starts programs but does not
/// confine them is tested.
std::string why_not(Tier tier) {
    try {
        return harness::try_canary(harness::Sandbox(tier)).failure;
    } catch (const harness::HarnessError& error) {
        return error.what();
    }
}

/// Shorter times than the defaults, so that the tests end sooner, but long enough for a busy machine.
Runner quick_runner(Tier tier) {
    auto [compile, run] = harness::read_limits({}, {});
    compile.cpu = 2s;
    compile.wall = 12s;
    run.cpu = 1s;
    run.wall = 4s;
    run.memory_bytes = std::uint64_t{128} << 20U;
    return harness::make_runner(std::make_unique<harness::Sandbox>(tier), harness::default_build_settings(compile),
                                run);
}

Submission take_in_one(const fs::path& path) {
    const auto taken = harness::take_in(path);
    if (taken.size() != 1 || taken[0].problem) throw std::runtime_error(path.string() + " is no submission");
    return taken[0];
}

/// For a program that was stopped at a limit, only the limit is known.
bool ended_by_itself(const Graded& graded) {
    return graded.execution.run.ended == harness::Ended::exited ||
           graded.execution.run.ended == harness::Ended::signalled;
}

/// Whether the program may have printed more than the grades keep.
bool may_have_printed_more(const Graded& graded) {
    return ended_by_itself(graded) && graded.execution.printout.empty() &&
           graded.execution.outcome != harness::Outcome::no_output;
}

harness::ProcessResult run_again(const Submission& submission, const Runner& runner) {
    const harness::Scratch scratch(runner.sandbox->workspace());
    const harness::Build build = harness::build(submission, runner.build, *runner.sandbox, scratch);
    return harness::run(build, runner.run, *runner.sandbox, scratch);
}

/// What a report must not contain: control bytes other than line ends and tabs, and invalid UTF-8.
std::optional<std::string> unprintable(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : ' ');
        const bool control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f;
        const bool control_of_8_bits = byte == 0xc2 && next >= 0x80 && next < 0xa0;
        if (control || control_of_8_bits) return "control character at byte " + std::to_string(i);
    }
    try {
        nlohmann::json(text).dump();
    } catch (const nlohmann::json::type_error& error) {
        return error.what();
    }
    return std::nullopt;
}

/// RFC 4180 ends lines with CR LF.
std::string with_plain_line_ends(std::string text) {
    for (std::size_t at = 0; (at = text.find("\r\n", at)) != std::string::npos;) text.erase(at, 1);
    return text;
}

/// Waits for processes that are about to end, such as the first process of a namespace whose outer process is gone.
void expect_no_process_left() {
    const auto end = std::chrono::steady_clock::now() + 2s;
    pid_t pid = 0;
    while ((pid = waitpid(-1, nullptr, WNOHANG)) >= 0 && std::chrono::steady_clock::now() < end) {
        std::this_thread::sleep_for(10ms);
    }
    EXPECT_LT(pid, 0) << "a process is left over";
}

void expect_only_our_files_in(const fs::path& workspace) {
    for (const auto& entry : fs::directory_iterator(workspace))
        EXPECT_THAT(entry.path().filename(), testing::AnyOf("supervisor", "line_buffer.so", "huge_pages.so"));
}

void expect_fair_outcome(const Graded& graded, const Attack& attack) {
    EXPECT_THAT(attack.outcomes, testing::Contains(harness::to_string(graded.execution.outcome)))
        << "It tries " << attack.tries << ".\n"
        << graded.execution.explanation << '\n'
        << graded.execution.build.diagnostics.substr(0, 2000) << graded.execution.run.errors.substr(0, 2000);
    // Their output is right for the first question and for one or two more items.
    EXPECT_LE(graded.score.points, 15);
    if (graded.execution.outcome != harness::Outcome::graded) {
        EXPECT_NE(graded.execution.explanation, "");
    }
}

void expect_clean_reports(const std::vector<Graded>& graded, const harness::Marking& marking, Tier tier) {
    const std::map<std::string, std::string> reports = {
        {"grades.json", harness::report::grades_json(graded, marking, tier)},
        {"grades.csv", with_plain_line_ends(harness::report::grades_csv(graded))},
        {"the class table", harness::report::class_table(graded)},
        {"who needs a person", harness::report::needs_a_person(graded, "raygrade review out")},
        {"the feedback", harness::report::feedback_markdown(graded[0], marking)},
        {"the check", harness::report::check_text(graded[0])}};
    for (const auto& [name, text] : reports) {
        EXPECT_EQ(unprintable(text), std::nullopt) << name;
        EXPECT_EQ(stolen_word(text), "") << name;
        EXPECT_THAT(text, testing::Not(testing::HasSubstr("ESCAPED"))) << name;
    }
}

void expect_nothing_learnt(const std::map<std::string, std::string>& by_name) {
    for (const auto& [name, text] : by_name) {
        EXPECT_EQ(stolen_word(text), "") << name;
        const std::size_t at = text.find("ESCAPED");
        EXPECT_EQ(at, std::string::npos) << name << ": " << text.substr(at, 1000);
    }
}

class Hostile : public testing::Test {
  public:
    Hostile(Tier tier, Attack attack) : tier_(tier), attack_(std::move(attack)) {}

    void TestBody() override {
        if (const std::string reason = why_not(tier_); !reason.empty()) GTEST_SKIP() << reason;
        place_decoy_files();
        const DecoyListener listener;
        const DecoySegment segment;
        const Submission hostile = take_in_one(attack_.folder);
        const Submission neighbour = take_in_one(project / "tests/scenario/hostile/neighbour.cpp");
        const auto held_to =
            harness::make_marking(reference::load_assignment("a6-2021", project / "reference/assignments"));
        Runner runner = quick_runner(tier_);
        harness::Timeline timeline;
        const auto graded = harness::grade_all({hostile, neighbour}, held_to, runner, 2, timeline);

        expect_fair_outcome(graded[0], attack_);
        EXPECT_EQ(graded[1].execution.outcome, harness::Outcome::graded)
            << "the neighbour: " << graded[1].execution.explanation;
        EXPECT_EQ(graded[1].score.points, 100) << "the neighbour";
        expect_clean_reports(graded, held_to, tier_);
        expect_nothing_learnt({{"stdout", graded[0].execution.printout},
                               {"stderr", graded[0].execution.run.errors},
                               {"the compiler's messages", graded[0].execution.build.diagnostics}});
        if (may_have_printed_more(graded[0])) {
            const auto again = run_again(hostile, runner);
            // A bomb is refused in some runs and stopped in others.
            if (graded[0].execution.run.ended == harness::Ended::exited) {
                EXPECT_EQ(again.ended, harness::Ended::exited);
            }
            expect_nothing_learnt({{"stdout", again.output}, {"stderr", again.errors}});
        }
        EXPECT_FALSE(listener.was_called());
        EXPECT_THAT(changes_to_decoy_files(), testing::IsEmpty());
        runner.known_program.reset();  // and its folder
        expect_only_our_files_in(runner.sandbox->workspace().path());
        expect_no_process_left();
    }

  private:
    Tier tier_;
    Attack attack_;
};

TEST(HostileCorpus, StatesTheAttackAndTheOutcomeOfEveryProgram) {
    const std::vector<Attack> corpus = read_corpus(project / "submissions/hostile");
    EXPECT_GE(corpus.size(), 100U);
    for (const Attack& attack : corpus) {
        EXPECT_THAT(attack.outcomes, testing::Not(testing::IsEmpty())) << attack.name;
        for (const std::string& outcome : attack.outcomes) {
            EXPECT_THAT((std::vector<std::string>{"graded", "compile_error", "crashed", "timed_out", "output_limit",
                                                  "memory_limit", "no_output"}),
                        testing::Contains(outcome))
                << attack.name;
        }
    }
}

TEST(HostileCorpus, RunsInAtLeastOneTier) {
    std::vector<std::string> reasons;
    for (const TestedTier& tested : tiers) reasons.push_back(why_not(tested.tier));
    EXPECT_THAT(reasons, testing::Contains(""));
}

void register_attacks() {
    for (const Attack& attack : read_corpus(project / "submissions/hostile")) {
        for (const TestedTier& tested : tiers) {
            testing::RegisterTest((std::string("Hostile/") + tested.name).c_str(), attack.name.c_str(), nullptr,
                                  nullptr, __FILE__, __LINE__,
                                  [tier = tested.tier, attack]() -> Hostile* { return new Hostile(tier, attack); });
        }
    }
}

}  // namespace
}  // namespace hostile

int main(int argc, char** argv) {
    // /proc shows the environment with which a process was started.
    if (std::getenv(hostile::decoy_variable) == nullptr) {
        setenv(hostile::decoy_variable, hostile::decoy_value, 1);
        execv("/proc/self/exe", argv);
        return 1;
    }
    // A process that outlives its supervisor becomes a child of this process and is noticed here.
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    testing::InitGoogleMock(&argc, argv);
    hostile::register_attacks();
    return RUN_ALL_TESTS();
}
