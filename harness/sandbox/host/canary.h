// Finds a sandbox that works on this machine, by attacking it before the first submission can.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/sandbox/host/sandbox.h"

namespace harness {

/// An action that a sandbox must prevent.
struct Attempt {
    std::string what;    ///< "read a file of raygrade's"
    bool held = false;   ///< whether the sandbox prevented it
    std::string detail;  ///< the kernel's message: "No such file or directory"
};

/// The result of attacking a tier.
struct CanaryReport {
    Tier tier;
    std::string failure;            ///< why nothing could be run in it; empty if the canary ran
    std::vector<Attempt> attempts;  ///< all of them in a fixed order; none after a failure

    bool held() const;
    /// One line: the attacks that succeeded, or that none did.
    std::string summary() const;
};

/// Runs raygrade-canary in the sandbox. It tries to read and overwrite a decoy file, to connect to a listener of this
/// process, to signal this process, to make a user namespace, to leave a file behind and to start more processes than
/// allowed. If a result is visible from outside, this process checks it itself. Takes about 40 ms.
CanaryReport try_canary(const Sandbox& sandbox);

/// What to do if no sandbox works on this machine.
enum class WithoutSandbox { refuse, run_unsafe };

struct Choice {
    std::unique_ptr<Sandbox> sandbox;   ///< of the strongest tier that resisted
    std::vector<CanaryReport> reports;  ///< one per tier tried, the chosen tier last; none for Tier::unsafe
};

/// Tries only the tier `only`, if given, else bwrap and then landlock. If none resists and `without` is refuse, throws
/// HarnessError with the failures and how to fix them.
Choice choose_sandbox(std::optional<Tier> only, WithoutSandbox without);

}  // namespace harness
