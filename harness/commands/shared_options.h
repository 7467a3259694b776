// Options that several subcommands take: each sets its default and is read into what it is given.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "harness/commands.h"
#include "harness/variants/run_variants.h"
#include "harness/workshop.h"

namespace harness {

/// The subcommand `name`: `add` adds its options, which are read into what `run` is given.
template <class Options>
Subcommand subcommand(CLI::App& app, const char* name, const char* about, void (*add)(CLI::App&, Options&),
                      int (*run)(const Options&)) {
    CLI::App& command = *app.add_subcommand(name, about);
    const auto options = std::make_shared<Options>();
    add(command, *options);
    return {&command, [options, run] { return run(*options); }};
}

CLI::Option* add_assignment(CLI::App& command, std::string& assignment);

/// As many as the machine has cores; `meaning` is its line of the help.
void add_jobs(CLI::App& command, int& jobs, const char* meaning);

void add_junit(CLI::App& command, std::filesystem::path& junit);

void add_workshop(CLI::App& command, WorkshopOptions& workshop);

void add_variants(CLI::App& command, variants::VariantOptions& options);

/// The table of limits below the help of a command.
std::string limits_footer();

}  // namespace harness
