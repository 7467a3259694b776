// The sandbox for tests that need any sandbox.
#pragma once

#include "harness/sandbox/host/canary.h"

/// The strongest tier that works on this machine. In a container or a chroot bwrap may fail.
inline harness::Tier strongest_tier() {
    static const harness::Tier tier =
        harness::choose_sandbox(std::nullopt, harness::WithoutSandbox::refuse).sandbox->tier();
    return tier;
}
