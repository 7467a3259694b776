// Runs the misbehaving helper program for the tests of run_process.
#pragma once

#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "harness/sandbox/host/command.h"
#include "harness/sandbox/host/process.h"
#include "harness/sandbox/host/sandbox.h"
#include "harness/sandbox/host/scratch.h"

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;

/// The sandbox of a tier. Each is made once. raygrade, too, makes its sandbox before it starts threads: if another
/// thread forked meanwhile, the child would hold the supervisor's copy open for writing, and the kernel refuses to
/// start a program that is open for writing.
std::shared_ptr<harness::Sandbox> sandbox_of(harness::Tier tier);

/// Why no program can be started in the tier on this machine; "" if programs can be started.
std::string why_not_here(harness::Tier tier);

/// A run whose processes can be recognised in /proc by an environment variable of their own. The limits are so high
/// that no well-behaved helper reaches them, even on a busy machine.
class Stranger {
  public:
    Stranger(std::shared_ptr<harness::Sandbox> sandbox, std::vector<std::string> arguments);

    harness::ProcessResult operator()() const { return harness::run_process(command, *sandbox_); }
    std::vector<harness::ProcessResult> on_each(const std::vector<std::string>& inputs) const {
        return harness::run_process_on_each(inputs, command, *sandbox_);
    }

    /// The number of this run's processes, including the supervisor.
    int alive() const;
    /// Waits at most ten seconds until `wanted` accepts the number of processes. Returns false if it never does.
    bool waits_for(bool (*wanted)(int)) const;

    harness::Command command;
    const std::filesystem::path& folder() const { return scratch_.path(); }
    void remove_supervisor() const { std::filesystem::remove(sandbox_->supervisor()); }
    std::string inside() const { return sandbox_->inside(folder()).string(); }

  private:
    std::shared_ptr<harness::Sandbox> sandbox_;
    harness::Scratch scratch_{sandbox_->workspace()};
    std::string mark_;
};

/// Runs a suite's tests in every tier: INSTANTIATE_TEST_SUITE_P(Tiers, Suite, every_tier(), name_of_tier).
class InEveryTier : public testing::TestWithParam<harness::Tier> {
  protected:
    /// Skips the test if this machine can't start programs in the tier.
    void SetUp() override {
        if (const std::string why = why_not_here(GetParam()); !why.empty()) GTEST_SKIP() << why;
    }
    static Stranger stranger(std::vector<std::string> arguments) {
        return {sandbox_of(GetParam()), std::move(arguments)};
    }
};

inline auto every_tier() {
    return testing::Values(harness::Tier::bwrap, harness::Tier::landlock, harness::Tier::unsafe);
}

inline std::string name_of_tier(const testing::TestParamInfo<harness::Tier>& tier) {
    return tier.param == harness::Tier::bwrap ? "bwrap" : tier.param == harness::Tier::landlock ? "landlock" : "unsafe";
}
