// The gate: compiling a program once for all scenes changes only the time. Sample submissions are tried on other and
// hard scenes, and beside that a copy is written, compiled, run and marked for each scene. Every outcome and every
// item's verdict must be the same; what is printed of memory that nobody set need not. By day every 11th sample is
// tried and one of twelve of its runs compared, by night every run of all samples and labelled programs.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <iostream>
#include <map>

#include "harness/grade/batch.h"
#include "harness/run/limits.h"
#include "harness/stress/run.h"
#include "harness/variants/run.h"
#include "reference/toml/assignment.h"
#include "tests/given/bytes_of.h"
#include "tests/given/cases.h"
#include "tests/given/strongest_tier.h"

namespace {

namespace fs = std::filesystem;
using harness::Graded;
using harness::Marking;
using harness::Runner;
using harness::Submission;
using harness::Timeline;

struct Class {
    std::string name;
    fs::path folder;
    std::string assignment;
};

std::vector<Class> classes() {
    const fs::path project = RAYGRADE_PROJECT;
    std::vector<Class> all{{"submissions", project / "submissions", "a6-2021"}};
    if (!is_nightly()) return all;
    all.push_back({"y2024", project / "submissions/2024", "a6-2024"});
    for (const char* name : {"edge", "miss", "offaxis"}) {
        const fs::path folder = project / "tests/given/labelled" / name;
        all.push_back({name, folder, (folder / "assignment.toml").string()});
    }
    return all;
}

std::vector<Submission> submissions_of(const Class& one) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(one.folder)) {
        if (fs::exists(entry.path() / "ray_cast.cpp")) files.push_back(entry.path() / "ray_cast.cpp");
    }
    std::sort(files.begin(), files.end());
    std::vector<Submission> submissions;
    const std::size_t one_of = is_nightly() ? 1 : 11;
    for (std::size_t i = 0; i < files.size(); i += one_of) {
        Submission submission;
        submission.id = files[i].parent_path().filename();
        submission.file = files[i];
        submission.source = bytes_of(files[i]);
        submissions.push_back(std::move(submission));
    }
    return submissions;
}

std::string verdicts_of(const Graded& graded) {
    std::string text = fmt::format("outcome {}\n", static_cast<int>(graded.execution.outcome));
    for (const auto& question : graded.score.questions) {
        for (const auto& item : question.items) {
            text += fmt::format("{}.{} {} {} {}\n", question.number, item.spec.id.name, static_cast<int>(item.verdict),
                                item.points, item.diagnosis);
        }
    }
    return text;
}

/// What a submission got on each scene, by its name and the scene's.
using Verdicts = std::map<std::string, std::string>;

class OneCompile : public testing::TestWithParam<Class> {};

TEST_P(OneCompile, GivesTheSameVerdictsAsCompilingEachScene) {
    const harness::StageLimits limits = harness::read_limits({}, {});
    const Runner runner = harness::make_runner(std::make_unique<const harness::Sandbox>(strongest_tier()),
                                               harness::default_build_settings(limits.compile), limits.run);
    const Marking marking =
        harness::make_class_marking(reference::load_assignment(GetParam().assignment, RAYGRADE_ASSIGNMENTS));
    const std::vector<Submission> submissions = submissions_of(GetParam());
    std::vector<std::string> sources;
    for (const Submission& submission : submissions) sources.push_back(submission.source);
    Timeline timeline;
    constexpr int jobs = 2;
    std::vector<Graded> graded = harness::grade_all(submissions, marking, runner, jobs, timeline);

    Verdicts once, each;
    std::vector<Submission> rewritten;
    std::vector<std::shared_ptr<const Marking>> markings;
    const auto take = [&](const harness::variants::Rewritten& one) {
        for (std::size_t i = 0; i < one.runs.size(); ++i) {
            const auto& run = one.runs[i];
            const auto source = with_scene(sources[one.index], one.literals, run.scene->scene.scene);
            ASSERT_EQ(run.graded.has_value(), source.has_value());
            constexpr std::size_t one_of = 12;  // by day
            if (!source || (!is_nightly() && (one.index + i) % one_of != 0)) continue;
            Submission submission = submissions[one.index];
            submission.id += " on " + run.scene->scene.name;
            submission.source = *source;
            once[submission.id] = verdicts_of(*run.graded);
            rewritten.push_back(std::move(submission));
            markings.push_back(run.scene->marking);
        }
    };
    const harness::variants::VariantsOptions options{.count = 4, .seed = 1};
    const auto watched = [&](const harness::variants::Trial& trial) {
        return harness::variants::Trial{trial.scenes_for, take};
    };
    Timeline of_scenes;
    harness::variants::run_rewritten(graded, sources, marking, runner, jobs, of_scenes,
                                     {watched(harness::variants::on_variants(graded, sources, marking, options)),
                                      watched(harness::stress::on_hard_scenes(graded, marking))});

    std::vector<const Marking*> held_to;
    for (const auto& one : markings) held_to.push_back(one.get());
    std::vector<std::string> ids;
    for (const Submission& submission : rewritten) ids.push_back(submission.id);
    const std::vector<Graded> compiled = harness::grade_each(std::move(rewritten), held_to, runner, jobs, timeline);
    for (std::size_t i = 0; i < compiled.size(); ++i) each[ids[i]] = verdicts_of(compiled[i]);
    for (const auto& [id, verdicts] : each) EXPECT_EQ(once[id], verdicts) << id;
    EXPECT_GE(each.size(), submissions.size());

    const std::string trace = of_scenes.chrome_trace();
    std::size_t builds = 0;
    for (std::size_t at = 0; (at = trace.find("\"build\"", at)) != std::string::npos; ++at) ++builds;
    std::cout << GetParam().name << ": " << of_scenes.finished << " runs of " << submissions.size()
              << " submissions took " << builds << " compilations; " << each.size() << " were compared\n";
    EXPECT_LT(builds, of_scenes.finished / 4) << "most programs are compiled once";
}

INSTANTIATE_TEST_SUITE_P(Classes, OneCompile, testing::ValuesIn(classes()),
                         [](const auto& one) { return one.param.name; });

}  // namespace
