// A run of the misbehaving helper, for the tests of run_process.
#pragma once

#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "harness/sandbox/sandbox.h"
#include "harness/sandbox/scratch.h"

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;

/// One for each tier, made once, as raygrade does before it starts threads: a fork of another thread meanwhile would
/// keep the supervisor's copy open for writing, and the kernel starts no such program.
std::shared_ptr<harness::Sandbox> sandbox_of(harness::Tier tier);

/// Why nothing can be started in the tier on this machine; empty when something can.
std::string why_not_here(harness::Tier tier);

/// Recognisable in /proc by an environment variable of its own. Its limits are such that no well-behaved helper comes
/// near them, even on a busy machine.
class Stranger {
  public:
    Stranger(std::shared_ptr<harness::Sandbox> sandbox, std::vector<std::string> arguments);

    harness::ProcessResult operator()() const { return harness::run_process(command, *sandbox_); }

    /// How many processes with the mark there are, the supervisor among them.
    int alive() const;
    /// Whether their number becomes one that is wanted, within ten seconds.
    bool waits_for(bool (*wanted)(int)) const;

    harness::Command command;
    const std::filesystem::path& folder() const { return scratch_.path(); }
    void remove_supervisor() const { std::filesystem::remove(sandbox_->shim()); }
    std::string inside() const { return sandbox_->inside(folder()).string(); }

  private:
    std::shared_ptr<harness::Sandbox> sandbox_;
    harness::Scratch scratch_{sandbox_->workspace()};
    std::string mark_;
};

/// A test for every tier, by INSTANTIATE_TEST_SUITE_P(Tiers, Its, every_tier(), name_of_tier).
class InEveryTier : public testing::TestWithParam<harness::Tier> {
  protected:
    /// A tier this machine can't start anything in can't be tested on it.
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
