#include "harness/cluster/cluster.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "harness/class_run/class_run.h"
#include "harness/class_run/into_results.h"
#include "harness/class_run/read_class.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/subcommands.h"
#include "harness/machine/errors.h"
#include "harness/machine/fingerprint.h"
#include "harness/machine/say.h"
#include "harness/run/limits.h"
#include "harness/run/sanitizer.h"
#include "harness/shards/shard.h"
#include "harness/stress/generate.h"
#include "harness/text/shell_word.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

struct ClusterOptions {
    std::vector<fs::path> paths;
    std::string assignment;
    fs::path out = "results";
    fs::path scripts = "cluster";
    int shards = 16;
    bool apply = false;
    bool again = false;
    RosterOptions rosters{};
    GradingOptions grading{};                   ///< read only to be checked; every machine is given the words
    std::vector<const CLI::Option*> for_grade;  ///< those of the options that are `grade`'s
    cluster::SlurmLimits limits{"", 0, 0, 4};   ///< 0 for what the assignment's limits come to
    bool submit = false;
};

/// "--repeat=2" for each option of `grade` that was given.
std::vector<std::string> given_words(const ClusterOptions& options) {
    std::vector<std::string> words;
    for (const CLI::Option* option : options.for_grade) {
        const std::string name = "--" + option->get_lnames().front();
        if (option->get_expected_max() == 0) {
            if (option->count() > 0) words.push_back(name);
            continue;
        }
        for (const std::string& value : option->results()) words.push_back(name + "=" + value);
    }
    return words;
}

cluster::Plan plan_of(const ClusterOptions& options, const ClassInputs& inputs) {
    cluster::Plan plan;
    plan.work = fs::current_path();
    plan.raygrade = fs::read_symlink("/proc/self/exe");
    plan.folder = fs::absolute(options.scripts).lexically_normal();
    plan.results = options.out;
    for (const fs::path& path : options.paths) plan.classes.push_back(fs::absolute(path).string());
    plan.options = given_words(options);
    if (!options.assignment.empty()) plan.options.push_back("--assignment=" + options.assignment);
    if (options.apply) plan.merge_options = {"--apply"};
    plan.shards = options.shards;
    Fingerprint fingerprint("raygrade/cluster/1");
    fingerprint.add(RAYGRADE_VERSION).add(inputs.file.toml).add(std::to_string(options.shards));
    for (const std::string& word : plan.options) fingerprint.add(word);
    for (const KeptInput& each : inputs.rosters.given()) fingerprint.add(each.content);
    for (const Submission& each : inputs.submissions) fingerprint.add(each.id).add(each.source);
    plan.fingerprint = fingerprint.hex() + "\n";
    return plan;
}

cluster::Work work_of(const ClusterOptions& options, const StageLimits& stages, std::size_t submissions) {
    cluster::Work work;
    work.submissions = submissions;
    work.shards = options.shards;
    const RunnerOptions& runner = options.grading.runner;
    const std::size_t hard_scenes = options.grading.hard_scenes ? stress::most_hard_scenes() : 0;
    work.scenes = 1 + options.grading.variants.count + static_cast<int>(hard_scenes);
    work.runs = runner.repetitions;
    work.compile = stages.compile.wall;
    work.run = stages.run.wall;
    work.memory_bytes = std::max(stages.compile.memory_bytes, stages.run.memory_bytes);
    if (runner.sanitize) {
        const Limits sanitized = sanitizer_limits(stages.run);
        work.sanitized = stages.compile.wall + sanitized.wall;
        work.memory_bytes = std::max(work.memory_bytes, sanitized.memory_bytes);
    }
    return work;
}

/// Becomes `bash SCRIPT`.
int become(const fs::path& script) {
    std::fflush(nullptr);
    execlp("bash", "bash", script.c_str(), static_cast<char*>(nullptr));
    throw HarnessError("bash can't be started.");
}

int write_cluster(const ClusterOptions& options) {
    ClassInputs inputs = read_class({options.paths, options.assignment, options.out, options.rosters}, options.grading);
    const StageLimits stages = read_limits(inputs.assignment.limits, options.grading.runner.limits);
    const cluster::Plan plan = plan_of(options, inputs);
    // Before any machine does: what is wrong with the lists of students is told here.
    name_submissions(inputs, options.rosters, Gradebook(options.out), options.out);
    const cluster::Work work = work_of(options, stages, inputs.submissions.size());
    const auto scripts = cluster::slurm_scripts(plan, cluster::limits_for(work, options.limits));
    cluster::write_scripts(plan, scripts, options.again ? cluster::OldParts::give_up : cluster::OldParts::keep);
    const fs::path start = plan.folder / "submit";
    if (options.submit) return become(start);
    fmt::print("cluster: {}\n", plan.folder.string());
    say("Start with: bash {}\nWatch with: bash {}\n", shell_word(start.string()),
        shell_word((plan.folder / "status").string()));
    return all_graded;
}

void add_class(CLI::App& slurm, ClusterOptions& options) {
    slurm.add_option("paths", options.paths, "What to grade, where all machines see it")
        ->required()
        ->type_name("PATH...");
    add_assignment(slurm, options.assignment)->default_str("that of the results in --out, else default");
    options.assignment.clear();
    slurm.add_option("-o,--out", options.out, "The folder of results that the parts are merged into")
        ->type_name("DIR")
        ->capture_default_str();
    slurm.add_option("--scripts", options.scripts, "The folder for the scripts, the parts and the logs")
        ->type_name("DIR")
        ->capture_default_str();
    slurm.add_option("--shards", options.shards, "How many shards to split the class into")
        ->check(CLI::Range(1, Shard::most))
        ->type_name("N")
        ->capture_default_str();
    slurm.add_flag("--apply", options.apply, "Let the merge write over the marks of an earlier run");
    slurm.add_flag("--again", options.again, "Grade all shards again, also those that are done");
}

/// Those that every shard is given.
void add_for_grade(CLI::App& slurm, ClusterOptions& options) {
    const auto before = slurm.get_options();
    add_rosters(slurm, options.rosters);
    add_variants(slurm, options.grading.variants);
    slurm.add_flag("--stress", options.grading.hard_scenes,
                   "Also run each program on the hard scenes of `raygrade stress`");
    add_runner(slurm, options.grading.runner);
    for (const CLI::Option* option : slurm.get_options()) {
        if (std::find(before.begin(), before.end(), option) == before.end()) options.for_grade.push_back(option);
    }
}

void add_slurm(CLI::App& slurm, ClusterOptions& options) {
    slurm.add_option("--partition", options.limits.partition, "Slurm's partition")
        ->type_name("NAME")
        ->default_str("Slurm's default");
    slurm.add_option("--cpus", options.limits.cpus, "Processors of a shard")
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->capture_default_str();
    const char* from_limits = "what the limits of the assignment come to";
    slurm.add_option("--minutes", options.limits.minutes, "How long a shard may take")
        ->check(CLI::Range(1, 1000000))
        ->type_name("N")
        ->default_str(from_limits);
    slurm.add_option("--memory-mib", options.limits.memory_mib, "The memory of a shard")
        ->check(CLI::Range(1, 100000000))
        ->type_name("N")
        ->default_str(from_limits);
    slurm.add_flag("--submit", options.submit, "Submit it at once, or what of it failed");
    slurm.footer("Example: raygrade cluster slurm class/ --assignment a6-2021 --out results --shards 32 --submit");
}

}  // namespace

Subcommand cluster_command(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("cluster", "Write the scripts that grade a class on several machines, by Slurm");
    command.require_subcommand(1);
    const auto options = std::make_shared<ClusterOptions>();
    CLI::App& slurm = *command.add_subcommand("slurm", "A Slurm array job of shards, and a job that merges them");
    add_class(slurm, *options);
    add_for_grade(slurm, *options);
    add_slurm(slurm, *options);
    return {&command, [options] { return write_cluster(*options); }};
}

}  // namespace harness
