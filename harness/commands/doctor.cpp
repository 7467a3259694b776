#include "harness/doctor/doctor.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "harness/commands/options/subcommand.h"
#include "harness/text/color.h"
#include "reference/kernel/self_test.h"

namespace harness {
namespace {

/// The word for a level and its color.
std::pair<std::string_view, Color> shown(MachineFinding::Level level) {
    switch (level) {
        case MachineFinding::Level::good: return {"good", Color::green};
        case MachineFinding::Level::warning: return {"warning", Color::yellow};
        case MachineFinding::Level::bad: break;
    }
    return {"BAD", Color::red};
}

/// Indents the lines after the first, so that they align with it.
std::string indented(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '\n' ? "\n           " : std::string(1, c);
    return result;
}

/// Every decision and every mark depends on this.
MachineFinding arithmetic() {
    const std::string trouble = reference::kernel::arithmetic_trouble();
    if (trouble.empty())
        return {"arithmetic", MachineFinding::Level::good, "known hard cases are computed correctly", ""};
    return {"arithmetic", MachineFinding::Level::bad, trouble, "build raygrade as README.md says"};
}

void print_findings(const std::vector<MachineFinding>& findings, bool bad) {
    const Colors colors = colors_of_stdout();
    for (const MachineFinding& finding : findings) {
        const auto [word, color] = shown(finding.level);
        fmt::print("{} {}: {}\n", colored(fmt::format("{:<8}", word), color, colors), finding.what,
                   indented(finding.detail));
        if (!finding.way_out.empty()) fmt::print("{:<8} -> {}\n", "", finding.way_out);
    }
    fmt::print("{}\n", bad ? "This machine can't grade yet." : "This machine is ready to grade.");
}

int tell_findings() {
    std::vector<MachineFinding> findings = examine_machine();
    findings.push_back(arithmetic());
    const bool bad = std::any_of(findings.begin(), findings.end(),
                                 [](const MachineFinding& f) { return f.level == MachineFinding::Level::bad; });
    print_findings(findings, bad);
    return bad ? some_not_graded : all_graded;
}

}  // namespace

Subcommand doctor_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("doctor", "Check whether this machine can grade, and how to fix it");
    command.footer("The exit status is 1 if this machine can't grade yet.\nExample: raygrade doctor");
    return {&command, tell_findings};
}

}  // namespace harness
