#include "harness/variants/rewritten/run_rewritten.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <stdexcept>

#include "harness/grade/grade_submission.h"
#include "harness/machine/errors.h"
#include "harness/record/marking.h"
#include "harness/run/limits.h"
#include "harness/run/runner.h"
#include "harness/run/timeline.h"
#include "reference/toml/assignment.h"
#include "tests/given/strongest_tier.h"

namespace harness::variants {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const source::DecimalScene& scene() {
    static const source::DecimalScene a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS).scene;
    return a6;
}

const Marking& marking_of_a6() {
    static const Marking marking = make_marking(reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS));
    return marking;
}

/// Four submissions. All have a right answer except the second.
std::vector<Graded> four() {
    std::vector<Graded> all(4);
    for (Graded& one : all) {
        one.execution.outcome = Outcome::graded;
        one.score.questions = {{5, "", ItemVerdict::right, 10, 10, {ItemScore{}}}};
        one.score.questions[0].items[0].verdict = ItemVerdict::right;
        one.score.questions[0].items[0].printed = "1";
    }
    all[1].score.questions.clear();
    return all;
}

/// Runs the class without any scene, so nothing is compiled. Returns the submissions that were concluded.
template <class ForOne, class Conclude>
std::vector<std::size_t> concluded(std::vector<Graded>& graded, ForOne for_one, Conclude conclude) {
    const std::vector<std::string> sources(graded.size());
    const std::vector<MarkedScene> none;
    std::vector<std::size_t> indices;
    Timeline timeline;
    const auto scenes_for = [&](std::size_t index, const source::PartSet&) -> const auto& {
        for_one(index);
        return none;
    };
    const auto note = [&](const Rewritten& one) {
        conclude(one.index);
        indices.push_back(one.index);
    };
    run_rewritten(graded, sources, marking_of_a6(), Runner{}, 1, timeline, {{scenes_for, note}});
    return indices;
}

void nothing(std::size_t /*index*/) {}

/// Throws for the first submission.
template <class Error>
void fail_for_first(std::size_t index) {
    if (index == 0) throw Error("stoi\x1b");
}

TEST(RunRewritten, TriesEverySubmissionWithARightAnswer) {
    std::vector<Graded> graded = four();
    EXPECT_THAT(concluded(graded, nothing, nothing), ElementsAre(0, 2, 3));
    for (const Graded& one : graded) {
        EXPECT_FALSE(one.execution.our_fault);
        EXPECT_THAT(one.submission.notes, IsEmpty());
    }
}

TEST(RunRewritten, NotesAFaultOfRaygradeOnOneSubmission) {
    for (const bool while_drawing : {true, false}) {
        std::vector<Graded> graded = four();
        const auto fail = fail_for_first<std::out_of_range>;
        const auto tried = while_drawing ? concluded(graded, fail, nothing) : concluded(graded, nothing, fail);
        EXPECT_THAT(tried, ElementsAre(2, 3));
        EXPECT_TRUE(graded[0].execution.our_fault);
        EXPECT_EQ(graded[0].execution.outcome, Outcome::graded) << "it has its marks";
        EXPECT_THAT(graded[0].submission.notes,
                    ElementsAre("Other scenes: raygrade failed: stoi\\x1b. Please report this with the submission."));
        for (std::size_t i = 1; i < graded.size(); ++i) {
            EXPECT_FALSE(graded[i].execution.our_fault) << i;
            EXPECT_THAT(graded[i].submission.notes, IsEmpty()) << i;
        }
    }
}

TEST(RunRewritten, DistinguishesTheMachinesFailureFromItsOwnFault) {
    std::vector<Graded> graded = four();
    EXPECT_THAT(concluded(graded, fail_for_first<HarnessError>, nothing), ElementsAre(2, 3));
    EXPECT_FALSE(graded[0].execution.our_fault);
    EXPECT_THAT(
        graded[0].submission.notes,
        ElementsAre("It was not run on other scenes because raygrade failed. This is not the program's fault."));
}

/// Runs a program on the assignment's scene, and then on two other scenes, in which the sphere's radius is 3 and 5.
struct OnThreeScenes {
    /// `forget` takes from the first run whatever scene of its own was found.
    explicit OnThreeScenes(const std::string& source, bool forget = false) {
        const StageLimits limits = read_limits({}, {});
        const Runner runner = make_runner(std::make_unique<const Sandbox>(strongest_tier()),
                                          default_build_settings(limits.compile), limits.run);
        const Marking marking = make_marking(reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS));
        std::vector<reference::Variant> others;
        for (const char* radius : {"3", "5"}) {
            others.push_back({std::string("radius ") + radius, scene()});
            others.back().scene.spheres.front().radius = reference::Decimal::parse(radius).value();
        }
        std::vector<MarkedScene> scenes;
        for (auto& marked : with_keys(others, marking)) scenes.push_back(std::move(marked.value()));
        Submission submission;
        submission.id = "ada";
        submission.source = source;
        std::vector<Graded> graded{grade(submission, marking, runner)};
        // Whatever it printed, there is something to try.
        graded[0].score.questions = four()[0].score.questions;
        if (forget) graded[0].findings.own_scene.reset();
        Timeline timeline;
        const auto scenes_for = [&](std::size_t, const source::PartSet&) -> const auto& {
            return scenes;
        };
        const auto note = [&](const Rewritten& one) {
            for (const SceneRun& run : one.runs) {
                printed.push_back(run.graded.value().execution.printout);
                sets_own_scene.push_back(run.graded->findings.own_scene.has_value());
            }
        };
        run_rewritten(graded, {source}, marking, runner, 1, timeline, {{scenes_for, note}});
        const std::string trace = timeline.chrome_trace();
        for (std::size_t at = 0; (at = trace.find("\"build\"", at)) != std::string::npos; ++at) ++compiled;
    }

    // on the two other scenes
    std::vector<std::string> printed;
    std::vector<bool> sets_own_scene;
    std::size_t compiled = 0;  ///< how often something was compiled for them
};

TEST(RunRewritten, CompilesAProgramOnceForAllScenes) {
    const OnThreeScenes run("#include <cstdio>\nint main() { float R = 2; printf(\"R %g\\n\", R); }\n");
    EXPECT_THAT(run.printed, ElementsAre("R 3\n", "R 5\n"));
    EXPECT_EQ(run.compiled, 1U);
}

TEST(RunRewritten, CompilesEachSceneWhereANumberMustBeAConstant) {
    const OnThreeScenes run(
        "#include <cstdio>\nconstexpr int R = 2;\nchar a[R];\n"
        "int main() { printf(\"R %zu\\n\", sizeof a); }\n");
    EXPECT_THAT(run.printed, ElementsAre("R 3\n", "R 5\n"));
    EXPECT_EQ(run.compiled, 3U);
}

TEST(RunRewritten, CompilesEachSceneOfAProgramWhoseCopyPrintsSomethingElse) {
    for (const char* odd : {
             // tells a constant from a variable
             "#include <cstdio>\n#define R 2\nint main() { printf(\"R %d\\n\", __builtin_constant_p(R) ? R : 7); }\n",
             // shows its own text
             "#include <cstdio>\n#define SHOW(x) #x\n#define TEXT(x) SHOW(x)\n#define R 2\n"
             "int main() { puts(\"R \" TEXT(R)); }\n",
             // takes the scene away before the copy reads it
             "#include <cstdio>\n#include <unistd.h>\nfloat R = 2;\n"
             "__attribute__((section(\".preinit_array\"), used)) static void (*const early)() = [] { close(0); };\n"
             "int main() { printf(\"R %g\\n\", R); }\n",
         }) {
        const OnThreeScenes run(odd);
        EXPECT_THAT(run.printed, ElementsAre("R 3\n", "R 5\n")) << odd;
        EXPECT_EQ(run.compiled, 3U) << odd;
    }
}

TEST(RunRewritten, SeeksASceneInTheSourceOnlyWhereTheFirstRunBelongedToOne) {
    // Right for the pixel (10, 20).
    const std::string source =
        "#include <cstdio>\nint pixel[] = {10, 20};\nint main() { float R = 2; printf(\"R %g\\n\", R);\n"
        "puts(\"Question 1: Pixel in VCS: vec3(-1.860465, -0.796020, -2.000000)\");\n"
        "puts(\"Question 4: Pixel in WCS: vec3(-1.860465, -0.796020, 2.000000)\");\n"
        "puts(\"Question 5: V: vec3(-0.653904, -0.279780, -0.702946)\"); }\n";
    EXPECT_THAT(OnThreeScenes(source).sets_own_scene, ElementsAre(true, true));
    EXPECT_THAT(OnThreeScenes(source, true).sets_own_scene, ElementsAre(false, false));
}

}  // namespace
}  // namespace harness::variants
