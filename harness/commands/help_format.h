// The layout of `--help`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace harness {

/// "raygrade assignment check"
std::string way_to(const CLI::App& command);

/// The first example of the command's help: "raygrade assignment check my.toml"; empty if it shows none.
std::string example_of(const CLI::App& command);

/// The help of a command, in 80 columns. Options of a group other than CLI11's "Options" are shown only in the mode
/// All, of --help-all. `way` is the command with those above it.
std::string help_of(const CLI::App& command, const std::string& way, CLI::AppFormatMode mode);

}  // namespace harness
