#include "harness/workshop.h"

#include <fmt/format.h>

#include "harness/sandbox/canary.h"

namespace harness {
namespace {

std::optional<Tier> wanted_tier(const std::string& name) {
    if (name == "bwrap") return Tier::bwrap;
    if (name == "landlock") return Tier::landlock;
    return std::nullopt;
}

}  // namespace

Workshop open_workshop(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits) {
    const StageLimits stages = read_limits(limits, options.limits);
    const auto without = options.unsafe ? WithoutSandbox::run_unsafe : WithoutSandbox::refuse;
    Choice choice = choose_sandbox(wanted_tier(options.sandbox), without);
    return {std::move(choice.sandbox), default_build_settings(stages.compile), stages.run};
}

std::string sandbox_warning(Tier tier) {
    if (tier != Tier::unsafe) return {};
    return "Graded without a sandbox (--unsafe): a submission could have read and changed whatever the account that "
           "graded may, these reports and the answer key among it.";
}

void warn_of_no_sandbox(const Workshop& workshop) {
    const std::string warning = sandbox_warning(workshop.sandbox->tier());
    if (!warning.empty()) fmt::print(stderr, "raygrade: warning: {}\n", warning);
}

}  // namespace harness
