// Options that several subcommands take: each sets its default and is read into what it is given.
#pragma once

#include <filesystem>
#include <string>

#include "harness/variants/run_variants.h"
#include "harness/workshop.h"

namespace CLI {
class App;
}

namespace harness {

void add_assignment(CLI::App& command, std::string& assignment);

/// As many as the machine has cores; `meaning` is its line of the help.
void add_jobs(CLI::App& command, int& jobs, const char* meaning);

void add_junit(CLI::App& command, std::filesystem::path& junit);

void add_workshop(CLI::App& command, WorkshopOptions& workshop);

void add_variants(CLI::App& command, variants::VariantOptions& options);

/// The table of limits below the help of a command.
std::string limits_footer();

}  // namespace harness
