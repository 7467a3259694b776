// Finding out which sandbox this machine holds, by attacking it before the first submission does.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/sandbox/sandbox.h"

namespace harness {

/// One thing that a program in a sandbox must not be able to do.
struct Attempt {
    std::string what;    ///< "read a file of raygrade's"
    bool held = false;   ///< whether the sandbox held
    std::string detail;  ///< the kernel's word: "No such file or directory"
};

/// How a tier fared.
struct CanaryReport {
    Tier tier;
    std::string failure;            ///< why nothing could be run in it; empty when something could
    std::vector<Attempt> attempts;  ///< all of them, in their order; none under `failure`

    bool held() const;
    /// A line on what did not hold, or that all did.
    std::string summary() const;
};

/// Runs raygrade-canary in the sandbox: it tries to read and overwrite a decoy file, to connect to a listener of this
/// process, to signal this process, to make a user namespace, to leave a file behind and to start processes without
/// end. Whether it succeeded is decided from outside, where that can be seen from there. Some 40 ms.
CanaryReport try_canary(const Sandbox& sandbox);

/// What to do on a machine that holds no sandbox.
enum class WithoutSandbox { refuse, run_unsafe };

struct Choice {
    std::unique_ptr<Sandbox> sandbox;   ///< of the strongest tier that held
    std::vector<CanaryReport> reports;  ///< of each tier tried, the chosen one last; none of Tier::unsafe
};

/// Tries `only`, or else bwrap and then landlock. Throws HarnessError, with what failed and the way out, when none held
/// and that is refused.
Choice choose_sandbox(std::optional<Tier> only, WithoutSandbox without);

}  // namespace harness
