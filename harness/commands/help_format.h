// The layout of `--help`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace harness {

/// "raygrade assignment check"
std::string way_to(const CLI::App& command);

/// The first example of the command's help: "raygrade assignment check my.toml"; empty if the help has no example.
std::string example_of(const CLI::App& command);

/// `left`, and from `column` on the words of `text`, in lines of 80 columns.
std::string help_entry(const std::string& left, const std::string& text, std::size_t column);

/// The help of a command, in 80 columns. Options in a group other than CLI11's "Options" are shown only in mode All,
/// for --help-all. `way` is the command with its parent commands.
std::string help_of(const CLI::App& command, const std::string& way, CLI::AppFormatMode mode);

}  // namespace harness
