#include "harness/run/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "reference/toml/assignment_error.h"
#include "reference/toml/near_names.h"

namespace harness {
namespace {

using namespace std::chrono_literals;
using std::chrono::milliseconds;

constexpr std::uint64_t kibibyte = 1024;
constexpr std::uint64_t mebibyte = 1024 * kibibyte;

StageLimits default_limits() {
    return {.compile = {.cpu = 20s,
                        .wall = 100s,
                        .memory_bytes = 1024 * mebibyte,
                        .file_bytes = 64 * mebibyte,
                        .stack_bytes = 64 * mebibyte,
                        .output_bytes = 64 * kibibyte,
                        .error_bytes = 64 * kibibyte,
                        .processes = 32,
                        .open_files = 256},
            .run = {.cpu = 2s,
                    .wall = 10s,
                    .memory_bytes = 256 * mebibyte,
                    .file_bytes = 16 * mebibyte,
                    .stack_bytes = 64 * mebibyte,
                    .output_bytes = mebibyte,
                    .error_bytes = 64 * kibibyte,
                    .processes = 16,
                    .open_files = 64}};
}

/// A limit of one stage, with functions that read and write it in the unit of its name.
struct Setting {
    std::string_view name;
    double least, most;
    bool whole;
    void (*set)(Limits&, double);
    double (*get)(const Limits&);
    std::string_view of_program, of_compiler;  ///< the consequences
};

milliseconds to_milliseconds(double seconds) {
    return milliseconds(std::llround(seconds * 1000));
}

double to_seconds(milliseconds time) {
    return static_cast<double>(time.count()) / 1000;
}

std::uint64_t to_bytes(double count, std::uint64_t unit) {
    return static_cast<std::uint64_t>(count) * unit;
}

double to_units(std::uint64_t bytes, std::uint64_t unit) {
    return static_cast<double>(bytes / unit);
}

constexpr double longest_seconds = 86400;
constexpr double most_mib = 1 << 20;

const Setting settings[] = {
    {"cpu_seconds", 0.01, longest_seconds, false, [](Limits& l, double x) { l.cpu = to_milliseconds(x); },
     [](const Limits& l) { return to_seconds(l.cpu); },
     "Stops a program whose processes use more processor time: `timed_out`.",
     "Stops a compiler whose processes use more processor time: `compile_error`."},
    {"wall_seconds", 0.01, longest_seconds, false, [](Limits& l, double x) { l.wall = to_milliseconds(x); },
     [](const Limits& l) { return to_seconds(l.wall); },
     "Stops a program that takes longer, e.g. one that sleeps: `timed_out`.",
     "Stops a compiler that takes longer: `compile_error`."},
    {"memory_mib", 1, most_mib, true, [](Limits& l, double x) { l.memory_bytes = to_bytes(x, mebibyte); },
     [](const Limits& l) { return to_units(l.memory_bytes, mebibyte); },
     "Stops a program whose processes use more resident memory: `memory_limit`.",
     "Stops a compiler whose processes use more resident memory: `compile_error`."},
    {"output_kib", 1, most_mib, true, [](Limits& l, double x) { l.output_bytes = to_bytes(x, kibibyte); },
     [](const Limits& l) { return to_units(l.output_bytes, kibibyte); },
     "Stops a program that prints more: `output_limit`; the output so far is marked.",
     "Stops a compiler that prints more to stdout: `compile_error`."},
    {"errors_kib", 0, most_mib, true, [](Limits& l, double x) { l.error_bytes = to_bytes(x, kibibyte); },
     [](const Limits& l) { return to_units(l.error_bytes, kibibyte); },
     "Drops more output on stderr; the program goes on.", "Drops the rest of longer messages; the compiler goes on."},
    {"processes", 1, 4096, true, [](Limits& l, double x) { l.processes = static_cast<int>(x); },
     [](const Limits& l) { return static_cast<double>(l.processes); },
     "Stops a program with more processes and threads at a time: `crashed`.",
     "Stops a compiler with more processes and threads at a time: `compile_error`."},
    {"file_mib", 0, most_mib, true, [](Limits& l, double x) { l.file_bytes = to_bytes(x, mebibyte); },
     [](const Limits& l) { return to_units(l.file_bytes, mebibyte); },
     "A larger file ends the program with SIGXFSZ: `crashed`; in a sandbox, it can't write files at all.",
     "A larger file, e.g. for a huge array, makes the compiler fail: `compile_error`."},
    {"open_files", 8, 4096, true, [](Limits& l, double x) { l.open_files = static_cast<int>(x); },
     [](const Limits& l) { return static_cast<double>(l.open_files); },
     "Opening more files at a time fails; the program goes on.",
     "Opening more files at a time fails; the compiler says so."},
    {"stack_mib", 1, most_mib, true, [](Limits& l, double x) { l.stack_bytes = to_bytes(x, mebibyte); },
     [](const Limits& l) { return to_units(l.stack_bytes, mebibyte); },
     "A larger stack, e.g. by endless recursion, ends the program with SIGSEGV: `crashed`.",
     "A larger stack, e.g. for deep nesting, crashes the compiler: `compile_error`."},
};

struct LimitedStage {
    std::string_view name;
    Limits StageLimits::*limits;
    std::string_view Setting::*consequence;
};

const LimitedStage stages[] = {{"run", &StageLimits::run, &Setting::of_program},
                               {"compile", &StageLimits::compile, &Setting::of_compiler}};

/// Sets the limit called `name`. Throws LimitError.
void set(StageLimits& limits, std::string_view name, double value) {
    for (const LimitedStage& stage : stages) {
        for (const Setting& setting : settings) {
            if (name != fmt::format("{}.{}", stage.name, setting.name)) continue;
            const bool fits = setting.least <= value && value <= setting.most;
            if (!fits || (setting.whole && value != std::floor(value))) {
                throw LimitError(fmt::format("must be a {}number from {:g} to {:.0f}", setting.whole ? "whole " : "",
                                             setting.least, setting.most));
            }
            setting.set(limits.*stage.limits, value);
            return;
        }
    }
    std::vector<std::string> names;
    for (const LimitDescription& limit : describe_limits()) names.push_back(limit.name);
    const std::size_t dot = name.find('.');
    const bool has_stage =
        std::ranges::any_of(stages, [&](const LimitedStage& stage) { return stage.name == name.substr(0, dot); });
    throw LimitError("is not a limit; " + reference::did_you_mean(has_stage ? name : name.substr(dot + 1), names));
}

double read_value(std::string_view text) {
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && stop == text.data() + text.size()) return value;
    throw LimitError(fmt::format("is \"{}\", which is not a number", text));
}

/// Sets a limit from "name=value" on the command line and adds the name to `given`.
void set_from_command_line(StageLimits& limits, const std::string& text, std::set<std::string>& given) {
    const std::size_t middle = text.find('=');
    const std::string name = text.substr(0, middle);
    try {
        if (middle == std::string::npos) throw LimitError("needs a value, e.g. --limit run.cpu_seconds=4");
        set(limits, name, read_value(std::string_view(text).substr(middle + 1)));
    } catch (const LimitError& error) {
        throw LimitError(fmt::format("--limit {} {}", name, error.what()));
    }
    given.insert(name);
}

}  // namespace

std::vector<LimitDescription> describe_limits() {
    const StageLimits limits = default_limits();
    std::vector<LimitDescription> descriptions;
    for (const LimitedStage& stage : stages) {
        for (const Setting& setting : settings) {
            descriptions.push_back({fmt::format("{}.{}", stage.name, setting.name),
                                    fmt::format("{:g}", setting.get(limits.*stage.limits)),
                                    std::string(setting.*stage.consequence)});
        }
    }
    return descriptions;
}

StageLimits read_limits(const std::vector<reference::LimitEntry>& from_assignment,
                        const std::vector<std::string>& from_command_line) {
    StageLimits limits = default_limits();
    std::set<std::string> given;
    for (const reference::LimitEntry& entry : from_assignment) {
        try {
            set(limits, entry.name, entry.value);
        } catch (const LimitError& error) {
            throw reference::AssignmentError(fmt::format("{} {}", entry.place, error.what()));
        }
        given.insert(entry.name);
    }
    for (const std::string& text : from_command_line) set_from_command_line(limits, text, given);
    for (const LimitedStage& stage : stages) {
        Limits& one = limits.*stage.limits;
        if (!given.contains(fmt::format("{}.wall_seconds", stage.name))) one.wall = std::max(one.wall, 5 * one.cpu);
    }
    return limits;
}

}  // namespace harness
