#include "harness/run/run.h"

#include <gtest/gtest.h>

#include "harness/machine/errors.h"
#include "harness/run/limits.h"
#include "harness/sandbox/host/command.h"
#include "tests/given/strongest_tier.h"

namespace {

using harness::Build;
using harness::Ended;
using harness::ProcessResult;

class Run : public testing::Test {
  protected:
    ProcessResult run(const Build& build) const {
        return harness::run(build, harness::read_limits({}, {}).run, sandbox_, scratch_);
    }
    std::vector<ProcessResult> run_on_each(const std::vector<std::string>& inputs, const Build& build) const {
        return harness::run_on_each(inputs, build, harness::read_limits({}, {}).run, sandbox_, scratch_);
    }
    /// A build that looks as if the program had been compiled in the scratch folder.
    Build copy_of(const std::filesystem::path& program) const {
        Build build;
        build.program = scratch_.path() / "ray_cast";
        std::filesystem::copy_file(program, *build.program, std::filesystem::copy_options::overwrite_existing);
        return build;
    }

    /// The working directory, as the program finds it.
    std::string home() const { return sandbox_.inside(scratch_.path()).string(); }
    /// bwrap also sets this variable.
    bool has_pwd() const { return sandbox_.tier() == harness::Tier::bwrap; }

    harness::Sandbox sandbox_{strongest_tier()};
    harness::Scratch scratch_{sandbox_.workspace()};
};

TEST_F(Run, DoesNotStartABuildWithoutAProgram) {
    EXPECT_EQ(run(Build{}).ended, Ended::not_started);
    EXPECT_EQ(run_on_each({"a", "b"}, Build{}).at(1).ended, Ended::not_started);
}

TEST_F(Run, RunsTheProgramInItsScratchFolderWithAFreshEnvironment) {
    // The helper without a mode it knows exits with 93.
    EXPECT_EQ(run(copy_of(MISBEHAVE)).exit_code, 93);
    const harness::ProcessResult env = run(copy_of("/usr/bin/env"));
    EXPECT_EQ(env.output, "PATH=/usr/local/bin:/usr/bin:/bin\nLANG=C.UTF-8\nHOME=" + home() + "\nTMPDIR=" + home() +
                              "\nLD_PRELOAD=" + sandbox_.library_inside(sandbox_.line_buffer()).string() + "\n" +
                              (has_pwd() ? "PWD=" + home() + "\n" : ""));
    EXPECT_EQ(env.errors, "") << "nothing but the program writes to its standard error";
    EXPECT_EQ(run(copy_of("/usr/bin/pwd")).output, home() + "\n");
}

TEST_F(Run, GivesTheProgramItsInputAndThenTheEnd) {
    const std::string longest(harness::longest_input, 'x');
    const std::vector<std::string> inputs{std::string("a\0b\n", 4), longest, "", "c"};
    const auto results = run_on_each(inputs, copy_of("/bin/cat"));
    ASSERT_EQ(results.size(), inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        EXPECT_EQ(results[i].ended, Ended::exited);
        EXPECT_EQ(results[i].output, inputs[i]);
    }
    EXPECT_EQ(run(copy_of("/bin/cat")).output, "");
    EXPECT_THROW(run_on_each({"a", longest + "x"}, copy_of("/bin/cat")), harness::HarnessError);
}

}  // namespace
