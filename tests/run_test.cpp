#include "harness/run.h"

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace {

using harness::Build;
using harness::Ended;

TEST(Run, DoesNotStartABuildWithoutAProgram) {
    const TemporaryFolder folder;
    EXPECT_EQ(harness::run(Build{}, harness::default_run_limits(), folder.path()).ended, Ended::not_started);
}

TEST(Run, RunsTheProgramInItsScratchFolderWithAFreshEnvironment) {
    const TemporaryFolder folder;
    Build build;
    build.program = MISBEHAVE;
    // The helper without a mode it knows exits with 93.
    EXPECT_EQ(harness::run(build, harness::default_run_limits(), folder.path()).exit_code, 93);
    build.program = "/usr/bin/env";
    const std::string home = folder.path().string();
    EXPECT_EQ(harness::run(build, harness::default_run_limits(), folder.path()).output,
              "PATH=/usr/local/bin:/usr/bin:/bin\nLANG=C.UTF-8\nHOME=" + home + "\nTMPDIR=" + home + "\n");
    build.program = "/usr/bin/pwd";
    EXPECT_EQ(harness::run(build, harness::default_run_limits(), folder.path()).output, home + "\n");
}

}  // namespace
