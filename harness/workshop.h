// What turns a source into output: one for a run of raygrade.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "harness/build.h"
#include "harness/limit_settings.h"
#include "harness/sandbox/sandbox.h"

namespace harness {

struct Workshop {
    std::unique_ptr<const Sandbox> sandbox;
    BuildSettings build;
    Limits run;
};

struct WorkshopOptions {
    std::string sandbox = "auto";     ///< auto, bwrap or landlock
    bool unsafe = false;              ///< go on with limits alone where no sandbox holds
    std::vector<std::string> limits;  ///< "run.cpu_seconds=4"
};

/// Tries which sandbox this machine holds and reads the limits. Throws HarnessError, AssignmentError and LimitError.
Workshop open_workshop(const WorkshopOptions& options, const std::vector<reference::LimitEntry>& limits);

/// For every report of marks that were made without a sandbox; empty when there was one.
std::string sandbox_warning(Tier tier);

/// The same on stderr, before the first submission.
void warn_of_no_sandbox(const Workshop& workshop);

}  // namespace harness
