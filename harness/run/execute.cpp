#include "harness/run/execute.h"

#include <algorithm>
#include <cerrno>
#include <initializer_list>
#include <mutex>
#include <system_error>
#include <utility>

#include "harness/build/header_use.h"
#include "harness/run/run.h"
#include "harness/run/sanitizer.h"

namespace harness {
namespace {

bool is_sanitized(const Submission& submission, const Runner& runner) {
    return runner.sanitize && submission.inputs.empty();
}

/// The cache keys of the runs: one for each input; or else the first run, its repetitions, and finally the sanitized
/// run. Empty if nothing is cached.
std::vector<std::string> keys_of(const Submission& submission, const Runner& runner) {
    std::vector<std::string> keys;
    if (!runner.result_cache) return keys;
    const auto add = [&](const std::string& which) { keys.push_back(execution_key(submission.source, runner, which)); };
    for (const std::string& input : submission.inputs) add("with input " + input);
    if (!submission.inputs.empty()) return keys;
    add("first");
    for (int i = 2; i <= runner.repetitions; ++i) add("repetition " + std::to_string(i));
    if (runner.sanitize) add("sanitized");
    return keys;
}

std::optional<Executions> find_in_cache(const Submission& submission, const Runner& runner) {
    if (!runner.result_cache || runner.fresh || submission.problem) return {};
    Executions found;
    found.from_cache = true;
    for (const std::string& key : keys_of(submission, runner)) {
        auto kept = runner.result_cache->find(key);
        if (!kept) return {};
        found.runs.push_back(std::move(*kept));
    }
    if (is_sanitized(submission, runner)) {
        found.sanitized = std::move(found.runs.back());
        found.runs.pop_back();
    }
    return found;
}

void keep(const Executions& executions, const Submission& submission, const Runner& runner) {
    if (!runner.result_cache) return;
    const std::vector<std::string> keys = keys_of(submission, runner);
    for (std::size_t i = 0; i < executions.runs.size(); ++i) runner.result_cache->keep(keys[i], executions.runs[i]);
    if (executions.sanitized) runner.result_cache->keep(keys.back(), *executions.sanitized);
}

/// The precompiled header that an earlier run made for this source; empty if there is none. For a single source, none
/// is made.
std::optional<std::filesystem::path> kept_header(const Submission& submission, const Runner& runner) {
    if (!runner.headers || submission.problem) return {};
    const HeaderLines lines = header_use(submission.source).lines;
    if (!runner.headers->is_kept(lines)) return {};
    return runner.headers->get(lines);
}

/// Whether the machine and not the program may be the reason for a crash or an empty output, because it lacked memory
/// or part of a library.
bool may_be_the_machine(const ProcessResult& run) {
    return run.ended == Ended::signalled || (run.ended == Ended::exited && run.output.empty());
}

/// Whether the program reported that it got no memory or no more processes.
bool lacks_something(const ProcessResult& run) {
    const std::initializer_list<std::string> words{"bad_alloc", std::generic_category().message(ENOMEM),
                                                   std::generic_category().message(EAGAIN)};
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return run.errors.find(word) != std::string::npos; });
}

/// Runs a program again by itself, because the machine may have ended it. The second run counts if a program that is
/// known to be right runs in the same place.
void run_again(Execution& execution, const Runner& runner, const Scratch& program, const std::string& input) {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    execution.run = run_on_each({input}, execution.build, runner.run, *runner.sandbox, program).front();
    if (may_be_the_machine(execution.run)) runner.known_program->require_that_it_runs(runner.run);
    execution.depends_on_machine = !may_be_the_machine(execution.run) || lacks_something(execution.run);
}

/// Runs a program on each of the inputs. `executions`: one for each input, with the build.
void run_fairly(std::vector<Execution>& executions, const Runner& runner, const Scratch& program,
                const std::vector<std::string>& inputs) {
    std::vector<ProcessResult> runs =
        run_on_each(inputs, executions.front().build, runner.run, *runner.sandbox, program);
    for (std::size_t i = 0; i < executions.size(); ++i) {
        executions[i].run = std::move(runs[i]);
        if (may_be_the_machine(executions[i].run)) run_again(executions[i], runner, program, inputs[i]);
    }
}

}  // namespace

bool is_in_cache(const Submission& submission, const Runner& runner) {
    if (!runner.result_cache || runner.fresh || submission.problem) return false;
    const std::vector<std::string> keys = keys_of(submission, runner);
    return std::all_of(keys.begin(), keys.end(),
                       [&](const std::string& key) { return runner.result_cache->contains(key); });
}

Compiled compile(const Submission& submission, const Runner& runner, const std::optional<std::filesystem::path>& header,
                 Timeline& timeline) {
    Compiled compiled;
    if (auto found = find_in_cache(submission, runner)) {
        compiled.executions = std::move(*found);
        return compiled;
    }
    const Timeline::Span span(timeline, Stage::build, submission.id);
    Execution execution;
    compiled.program = std::make_unique<Scratch>(runner.sandbox->workspace());
    execution.build = build(submission, runner.build, *runner.sandbox, *compiled.program, header);
    const std::size_t runs =
        submission.inputs.empty() ? static_cast<std::size_t>(runner.repetitions) : submission.inputs.size();
    compiled.executions.runs.assign(runs, execution);
    if (!is_sanitized(submission, runner)) return compiled;
    BuildSettings settings = runner.build;
    for (const std::string& flag : sanitizer_flags()) settings.flags.push_back(flag);
    compiled.sanitized_program = std::make_unique<Scratch>(runner.sandbox->workspace());
    execution.build = build(submission, settings, *runner.sandbox, *compiled.sanitized_program);
    compiled.executions.sanitized = std::move(execution);
    return compiled;
}

Executions run_compiled(Compiled compiled, const Submission& submission, const Runner& runner, Timeline& timeline) {
    Executions& executions = compiled.executions;
    if (executions.from_cache) return std::move(executions);
    {
        const Timeline::Span span(timeline, Stage::run, submission.id);
        const bool has_inputs = !submission.inputs.empty();
        run_fairly(executions.runs, runner, *compiled.program,
                   has_inputs ? submission.inputs : std::vector<std::string>(executions.runs.size()));
        if (executions.sanitized) {
            executions.sanitized->run = run(executions.sanitized->build, sanitizer_limits(runner.run), *runner.sandbox,
                                            *compiled.sanitized_program, sanitizer_environment());
        }
    }
    keep(executions, submission, runner);
    return std::move(executions);
}

Executions execute(const Submission& submission, const Runner& runner, Timeline& timeline) {
    const auto header = is_in_cache(submission, runner) ? std::nullopt : kept_header(submission, runner);
    return run_compiled(compile(submission, runner, header, timeline), submission, runner, timeline);
}

}  // namespace harness
