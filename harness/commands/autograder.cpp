#include "harness/autograder/autograder.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "harness/commands/options/shared_options.h"
#include "harness/commands/options/subcommand.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "harness/machine/parts.h"
#include "harness/machine/say.h"
#include "harness/record/marking.h"
#include "harness/run/limits.h"
#include "harness/variants/points.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

struct AutograderOptions {
    std::string assignment;
    fs::path zip = "autograder.zip";  ///< of gradescope
    fs::path folder = "autograder";   ///< of classroom50
    std::string image;                ///< of classroom50
    bool force = false;               ///< replace an earlier autograder
    bool unsafe = false;              ///< of gradescope
    variants::VariantsOptions variants{};
};

/// Reads the assignment and refuses everything that grading would refuse, so that no submission meets a broken
/// assignment.
autograder::Settings read_settings(const AutograderOptions& options) {
    const auto file = reference::read_assignment_file(options.assignment, assignments_folder());
    reference::Assignment assignment = reference::parse_assignment(file.toml, file.path);
    if (!assignment.dealt.empty()) {
        throw UsageError(
            fmt::format("{} has a scene for each student, and an autograder does not know whose submission it grades. "
                        "Let the system collect the submissions, and grade its download with raygrade grade",
                        file.path.string()));
    }
    read_limits(assignment.limits, {});
    variants::require_variants(assignment, options.variants.count);
    autograder::Settings settings{file.path.filename().string(), file.toml, {}};
    if (options.variants.count > 0) {
        settings.options = {"--variants", std::to_string(options.variants.count), "--variant-seed",
                            std::to_string(options.variants.seed)};
    }
    for (const std::string& note : make_marking(std::move(assignment)).key.notes) say("note: {}\n", note);
    return settings;
}

/// Gradescope ends a container that takes more than 768 MiB, so the compiler gets less, unless the assignment sets this
/// limit.
void bound_compiler(autograder::Settings& settings) {
    constexpr const char* limit = "compile.memory_mib";
    const auto limits = reference::parse_assignment(settings.toml, settings.file_name).limits;
    if (std::ranges::any_of(limits, [&](const reference::LimitEntry& entry) { return entry.name == limit; })) return;
    settings.options.insert(settings.options.end(), {"--limit", fmt::format("{}=512", limit)});
}

int write_for_gradescope(const AutograderOptions& options) {
    require_can_write({options.zip, "--out", "zip", "PK\x03\x04"}, options.force ? Earlier::replaced : Earlier::kept);
    autograder::Settings settings = read_settings(options);
    bound_compiler(settings);
    if (options.unsafe) settings.options.emplace_back("--unsafe");
    write_file(options.zip, [&](std::ostream& stream) { autograder::write_gradescope_zip(stream, settings); });
    fmt::print("autograder: {}\n", options.zip.string());
    say("Upload it on Gradescope: Configure Autograder, Zip file upload, base image Ubuntu 22.04 or newer.\n");
    return all_graded;
}

int write_for_classroom50(const AutograderOptions& options) {
    if (look_into(options.folder, {"autograder.py"}, "assignment", {"an autograder", "--out"}) ==
            Holds::earlier_results &&
        !options.force) {
        throw UsageError(
            fmt::format("{} already has an autograder; replace it with --force, or name another folder with --out",
                        options.folder.string()));
    }
    const autograder::Settings settings = read_settings(options);
    make_folder(options.folder, "assignment");
    // The script uses the only assignment in this folder, so remove others.
    for (const auto& entry : fs::directory_iterator(options.folder / "assignment")) fs::remove(entry.path());
    for (const auto& [path, text] : autograder::classroom50_files(settings, options.image))
        write_file(options.folder / path, text);
    fmt::print("autograder: {}\n", options.folder.string());
    say("Copy the folder to CLASSROOM/autograders/ASSIGNMENT in your classroom50 repository, and pass its runtime.json "
        "to `gh teacher assignment add --runtime`.\n");
    return all_graded;
}

CLI::App* add_system(CLI::App& command, const char* name, const char* about, AutograderOptions& options) {
    CLI::App* system = command.add_subcommand(name, about);
    add_assignment(*system, options.assignment);
    system->add_flag("--force", options.force, "Replace an earlier autograder");
    add_variants(*system, options.variants);
    return system;
}

}  // namespace

Subcommand autograder_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("autograder", "Write an autograder for Gradescope or Classroom 50");
    command.require_subcommand(1);
    command.footer("Example: raygrade autograder gradescope --assignment a6-2021");
    const auto options = std::make_shared<AutograderOptions>();
    CLI::App* gradescope = add_system(command, "gradescope", "Write an autograder zip for Gradescope", *options);
    gradescope->add_option("-o,--out", options->zip, "Where to write the zip")
        ->type_name("FILE.zip")
        ->capture_default_str();
    gradescope->add_flag("--unsafe", options->unsafe,
                         "If no sandbox works in Gradescope's containers, run programs without one, as a user who "
                         "cannot read the assignment");
    gradescope->footer("Example: raygrade autograder gradescope --assignment a6-2021");
    CLI::App* classroom50 =
        add_system(command, "classroom50", "Write autograder.py and its files for Classroom 50", *options);
    classroom50
        ->add_option("--image", options->image,
                     "The public container image that GitHub runs it in, built from harness/debian/Dockerfile; see "
                     "`raygrade help lms`")
        ->type_name("NAME")
        ->required();
    classroom50->add_option("-o,--out", options->folder, "The folder for the files")
        ->type_name("DIR")
        ->capture_default_str();
    classroom50->footer("Example: raygrade autograder classroom50 --image ghcr.io/my-course/raygrade");
    return {&command,
            [=] { return gradescope->parsed() ? write_for_gradescope(*options) : write_for_classroom50(*options); }};
}

}  // namespace harness
