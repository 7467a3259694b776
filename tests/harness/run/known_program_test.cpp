#include "harness/run/known_program.h"

#include <gtest/gtest.h>

#include "harness/machine/errors.h"
#include "harness/run/limits.h"
#include "tests/given/strongest_tier.h"

namespace {

TEST(KnownProgram, RunsUnderTheUsualLimitsButNotUnderImpossibleOnes) {
    const harness::Sandbox sandbox{strongest_tier()};
    const harness::StageLimits limits = harness::read_limits({}, {});
    const harness::KnownProgram known(harness::default_build_settings(limits.compile), sandbox);
    EXPECT_NO_THROW(known.require_that_it_runs(limits.run));
    harness::Limits narrow = limits.run;
    narrow.file_bytes = narrow.output_bytes = 10;
    EXPECT_THROW(known.require_that_it_runs(narrow), harness::HarnessError);
    EXPECT_NO_THROW(known.require_that_it_runs(limits.run));
}

}  // namespace
