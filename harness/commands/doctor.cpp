#include "harness/run/doctor.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "harness/commands/subcommand.h"
#include "reference/kernel/self_test.h"

namespace harness {
namespace {

std::string_view mark(Finding::Level level) {
    switch (level) {
        case Finding::Level::good: return "good";
        case Finding::Level::warning: return "warning";
        case Finding::Level::bad: return "BAD";
    }
    return "";
}

/// Indents the lines after the first, so that they align with it.
std::string indented(const std::string& text) {
    std::string result;
    for (const char c : text) result += c == '\n' ? "\n           " : std::string(1, c);
    return result;
}

/// What every decision and every mark counts on.
Finding arithmetic() {
    const std::string trouble = reference::kernel::arithmetic_trouble();
    if (trouble.empty()) return {"arithmetic", Finding::Level::good, "known hard decisions come out right", ""};
    return {"arithmetic", Finding::Level::bad, trouble, "build raygrade as README.md says"};
}

int tell_findings() {
    std::vector<Finding> findings = examine_machine();
    findings.push_back(arithmetic());
    for (const Finding& finding : findings) {
        fmt::print("{:<8} {}: {}\n", mark(finding.level), finding.what, indented(finding.detail));
        if (!finding.way_out.empty()) fmt::print("{:<8} -> {}\n", "", finding.way_out);
    }
    const bool bad =
        std::any_of(findings.begin(), findings.end(), [](const Finding& f) { return f.level == Finding::Level::bad; });
    fmt::print("{}\n", bad ? "This machine can't grade yet." : "This machine is ready to grade.");
    return bad ? some_not_graded : all_graded;
}

}  // namespace

Subcommand doctor_command(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("doctor", "Say what this machine has and lacks for grading");
    return {&command, tell_findings};
}

}  // namespace harness
