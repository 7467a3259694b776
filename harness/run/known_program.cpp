#include "harness/run/known_program.h"

#include <utility>

#include "harness/machine/errors.h"
#include "harness/run/run.h"

namespace harness {

KnownProgram::KnownProgram(BuildSettings settings, const Sandbox& sandbox)
    : settings_(std::move(settings)), sandbox_(sandbox) {}

void KnownProgram::require_that_it_runs(const Limits& limits) const {
    const std::lock_guard lock(one_at_a_time_);
    if (!scratch_) {
        auto scratch = std::make_unique<Scratch>(sandbox_.workspace());
        Submission known;
        known.source = known_source;
        build_ = build(known, settings_, sandbox_, *scratch);
        scratch_ = std::move(scratch);
    }
    const ProcessResult result = run(build_, limits, sandbox_, *scratch_);
    if (result.ended == Ended::exited && result.exit_code == 0 && result.output == known_output) return;
    throw HarnessError(
        "The program was not marked: it ended without an answer, but so did a program that is known to be right. "
        "Run `raygrade doctor`, or raise the assignment's limits.");
}

}  // namespace harness
