// The sandbox of tests that need one and don't ask which.
#pragma once

#include "harness/sandbox/canary.h"

/// The strongest this machine holds. A container or a chroot may refuse what bwrap takes.
inline harness::Tier strongest_tier() {
    static const harness::Tier tier =
        harness::choose_sandbox(std::nullopt, harness::WithoutSandbox::refuse).sandbox->tier();
    return tier;
}
