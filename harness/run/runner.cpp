#include "harness/run/runner.h"

#include <fmt/format.h>

#include "harness/execution/tier.h"
#include "harness/machine/errors.h"
#include "harness/machine/fingerprint.h"
#include "harness/machine/say.h"
#include "harness/sandbox/host/canary.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

std::optional<Tier> wanted_tier(const std::string& name) {
    if (name == "bwrap") return Tier::bwrap;
    if (name == "landlock") return Tier::landlock;
    return std::nullopt;
}

void add_words(Fingerprint& fingerprint, const std::vector<std::string>& words) {
    fingerprint.add(static_cast<std::int64_t>(words.size()));
    for (const std::string& word : words) fingerprint.add(word);
}

void add_limits(Fingerprint& fingerprint, const Limits& limits) {
    fingerprint.add(limits.cpu.count()).add(limits.wall.count());
    for (const std::uint64_t bytes :
         {limits.memory_bytes, limits.file_bytes, limits.stack_bytes, limits.output_bytes, limits.error_bytes}) {
        fingerprint.add(static_cast<std::int64_t>(bytes));
    }
    fingerprint.add(limits.processes).add(limits.open_files);
}

std::string failures(const std::vector<CanaryReport>& reports) {
    std::string text;
    for (const CanaryReport& report : reports) {
        if (report.held()) continue;
        text += fmt::format("{}{} does not work here ({})", text.empty() ? "" : ", ", to_string(report.tier),
                            printable(report.summary()));
    }
    return text;
}

}  // namespace

Runner open_runner(const RunnerOptions& options, const std::vector<reference::LimitEntry>& limits) {
    const StageLimits stages = read_limits(limits, options.limits);
    const auto without = options.unsafe ? WithoutSandbox::run_unsafe : WithoutSandbox::refuse;
    BuildSettings build = default_build_settings(stages.compile);
    Choice choice = choose_sandbox(wanted_tier(options.sandbox), without);
    Runner runner = make_runner(std::move(choice.sandbox), std::move(build), stages.run);
    runner.why_no_stronger = failures(choice.reports);
    runner.repetitions = options.repetitions;
    runner.sanitize = options.sanitize;
    runner.experiments = options.experiments;
    runner.fresh = options.fresh;
    if (runner.build.compiler.empty()) return runner;
    try {
        runner.toolchain = examine_toolchain(runner.build.compiler);
    } catch (const HarnessError&) {
        return runner;  // the first build reports why the compiler cannot be run
    }
    if (!options.cache) return runner;
    runner.headers = std::make_unique<const HeaderCache>(*options.cache, runner.build, runner.toolchain.fingerprint,
                                                         *runner.sandbox);
    runner.result_cache = std::make_unique<ResultCache>(*options.cache);
    return runner;
}

Runner make_runner(std::unique_ptr<const Sandbox> sandbox, BuildSettings build, const Limits& run) {
    auto known_program = std::make_unique<const KnownProgram>(build, *sandbox);
    return {std::move(sandbox), {}, std::move(build), run, std::move(known_program)};
}

std::string execution_key(const std::string& source, const Runner& runner, const std::string& which) {
    // Raise the number when programs are compiled or run differently, e.g. in another environment.
    Fingerprint fingerprint("raygrade/execution/6");
    fingerprint.add(runner.toolchain.fingerprint).add(to_string(runner.sandbox->tier()));
    add_words(fingerprint, runner.build.flags);
    add_words(fingerprint, runner.build.linker);
    add_limits(fingerprint, runner.build.limits);
    add_limits(fingerprint, runner.run);
    return fingerprint.add(which).add(source).hex();
}

void tell_of_the_sandbox(const Runner& runner, const RunnerOptions& options) {
    if (options.unsafe && runner.sandbox->tier() != Tier::unsafe) {
        say("note: --unsafe is not needed here; programs run in the sandbox {}\n", to_string(runner.sandbox->tier()));
    }
    if (!runner.why_no_stronger.empty()) {
        say("note: programs run in {}, because {}; see `raygrade doctor`\n", to_string(runner.sandbox->tier()),
            runner.why_no_stronger);
    }
    const std::string warning = sandbox_warning(runner.sandbox->tier());
    if (!warning.empty()) say("raygrade: warning: {}\n", warning);
}

}  // namespace harness
