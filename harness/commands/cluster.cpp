#include "harness/cluster/cluster.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "harness/class_run/class_run.h"
#include "harness/class_run/into_results.h"
#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/say.h"
#include "harness/run/limits.h"
#include "harness/shards/shard.h"
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
    RosterOptions rosters{};
    GradingOptions grading{};                   ///< read only to check them; every machine gets the words
    std::vector<const CLI::Option*> for_grade;  ///< the options that `grade` has too
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

int write_cluster(const ClusterOptions& options) {
    // Reports errors in the class, the limits and the student lists here, before any machine starts.
    ClassInputs inputs = read_class(options.paths, options.assignment, options.out, options.rosters, options.grading);
    read_limits(inputs.assignment.limits, options.grading.runner.limits);
    name_submissions(inputs, options.rosters, Gradebook(options.out), options.out);
    cluster::Plan plan;
    plan.work = fs::current_path();
    plan.raygrade = fs::read_symlink("/proc/self/exe");
    plan.folder = fs::absolute(options.scripts).lexically_normal();
    plan.results = options.out;
    for (const fs::path& path : options.paths) plan.classes.push_back(fs::absolute(path).string());
    plan.options = given_words(options);
    plan.shards = options.shards;
    cluster::write_scripts(plan);
    fmt::print("cluster: {}\n", plan.folder.string());
    say("Start: bash {}\nWatch: bash {}\n", shell_word((plan.folder / "submit").string()),
        shell_word((plan.folder / "status").string()));
    return all_graded;
}

void add_slurm(CLI::App& slurm, ClusterOptions& options) {
    slurm.add_option("paths", options.paths, "A class to grade, in a folder that all machines can read")
        ->required()
        ->type_name("PATH...");
    slurm.add_option("-o,--out", options.out, "The results folder that the parts are merged into")
        ->type_name("DIR")
        ->capture_default_str();
    slurm.add_option("--scripts", options.scripts, "The folder for scripts, parts and logs")
        ->type_name("DIR")
        ->capture_default_str();
    slurm.add_option("--shards", options.shards, "Into how many shards to split the class")
        ->check(number(1, Shard::most))
        ->type_name("N")
        ->capture_default_str();
    const auto own = slurm.get_options();
    add_assignment(slurm, options.assignment)->default_str("that of the results in --out, else the one named default");
    options.assignment.clear();
    add_rosters(slurm, options.rosters);
    add_variants(slurm, options.grading.variants);
    slurm.add_flag("--stress", options.grading.hard_scenes,
                   "Also run each program on hard scenes, as `raygrade stress` does");
    add_runner(slurm, options.grading.runner);
    for (const CLI::Option* option : slurm.get_options()) {
        if (std::ranges::find(own, option) == own.end()) options.for_grade.push_back(option);
    }
    slurm.footer(
        "Example: raygrade cluster slurm class/ --assignment a6-2021 --out results --shards 32\n         bash "
        "cluster/submit --cpus-per-task=4 --time=60 --mem=8G   (any options of sbatch)");
}

}  // namespace

Subcommand cluster_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("cluster", "Write the scripts that grade a class on a Slurm cluster");
    command.require_subcommand(1);
    command.footer("Example: raygrade cluster slurm class/ --assignment a6-2021");
    const auto options = std::make_shared<ClusterOptions>();
    add_slurm(
        *command.add_subcommand("slurm", "Write a Slurm array job that grades shards, and a job that merges them"),
        *options);
    return {&command, [options] { return write_cluster(*options); }};
}

}  // namespace harness
