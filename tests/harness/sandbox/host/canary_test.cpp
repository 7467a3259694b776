#include "harness/sandbox/host/canary.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include "harness/machine/errors.h"

namespace {

using harness::CanaryReport;
using harness::choose_sandbox;
using harness::HarnessError;
using harness::Sandbox;
using harness::Tier;
using harness::try_canary;
using harness::WithoutSandbox;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

const harness::Attempt& attempt(const CanaryReport& report, const std::string& what) {
    for (const auto& one : report.attempts) {
        if (one.what == what) return one;
    }
    throw std::runtime_error("no attempt to " + what);
}

TEST(Canary, IsStoppedByBothSandboxes) {
    for (const Tier tier : {Tier::bwrap, Tier::landlock}) {
        const CanaryReport report = try_canary(Sandbox(tier));
        if (!report.failure.empty()) continue;  // a container may refuse to start programs in this sandbox
        EXPECT_TRUE(report.held()) << to_string(tier) << ": " << report.summary();
        EXPECT_EQ(report.attempts.size(), 7U);
        EXPECT_EQ(report.summary(), "stopped all 7 attacks");
    }
}

/// Without a sandbox the canary must report escapes. That shows that it can detect them.
TEST(Canary, EscapesIfThereIsNoSandbox) {
    const CanaryReport report = try_canary(Sandbox(Tier::unsafe));
    EXPECT_FALSE(report.held());
    for (const char* what : {"read one of raygrade's files", "overwrite it", "leave a file behind",
                             "connect to a port of this machine", "create a user namespace"}) {
        EXPECT_FALSE(attempt(report, what).held) << what << ": " << attempt(report, what).detail;
    }
    EXPECT_TRUE(attempt(report, "start processes without limit").held) << "limits hold also without a sandbox";
    EXPECT_THAT(report.summary(),
                HasSubstr("a program in it could read one of raygrade's files (raygrade saw it succeed)"));
}

TEST(ChooseSandbox, TakesTheStrongestTierThatWorks) {
    const auto choice = choose_sandbox(std::nullopt, WithoutSandbox::refuse);
    const bool first_holds = choice.reports.front().held();
    EXPECT_EQ(choice.reports.front().tier, Tier::bwrap);
    EXPECT_EQ(choice.reports.size(), first_holds ? 1U : 2U);
    EXPECT_EQ(choice.sandbox->tier(), first_holds ? Tier::bwrap : Tier::landlock);
    EXPECT_TRUE(choice.reports.back().held());
    EXPECT_EQ(choose_sandbox(Tier::landlock, WithoutSandbox::refuse).sandbox->tier(), Tier::landlock);
}

}  // namespace
