#include "harness/run/sanitizer.h"

#include <gmock/gmock.h>

#include "harness/run/limits.h"
#include "harness/run/run.h"
#include "harness/sandbox/host/canary.h"

namespace {

using harness::sanitizer_findings;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(SanitizerFindings, IncludeUndefinedBehaviour) {
    EXPECT_THAT(sanitizer_findings("ray_cast.cpp:12:9: runtime error: division by zero\n"
                                   "my own words\n"
                                   "ray_cast.cpp:20:3: runtime error: load of null pointer of type 'int'\n"),
                ElementsAre("ray_cast.cpp:12:9: runtime error: division by zero",
                            "ray_cast.cpp:20:3: runtime error: load of null pointer of type 'int'"));
}

TEST(SanitizerFindings, NameTheStudentsLineOfABadAddress) {
    EXPECT_THAT(
        sanitizer_findings(
            "=================================================================\n"
            "==2==ERROR: AddressSanitizer: stack-buffer-overflow on address 0x7ffd4 at pc 0x55 bp 0x7f sp 0x7f\n"
            "WRITE of size 4 at 0x7ffd4 thread T0\n"
            "    #0 0x5589 in std::vector<int>::at(unsigned long) /usr/include/c++/12/bits/stl_vector.h:1123\n"
            "    #1 0x5589 in main /submission/ray_cast.cpp:30\n"
            "    #2 0x7f8c in main /submission/ray_cast.cpp:99\n"
            "SUMMARY: AddressSanitizer: stack-buffer-overflow ray_cast.cpp:30 in main\n"),
        ElementsAre("line 30: stack-buffer-overflow"));
}

TEST(SanitizerFindings, MayLackALine) {
    EXPECT_THAT(sanitizer_findings("==2==ERROR: AddressSanitizer: SEGV on unknown address 0x0\n"), ElementsAre("SEGV"));
    EXPECT_THAT(sanitizer_findings("==2==ERROR: AddressSanitizer: SEGV on unknown address 0x0\n"
                                   "SUMMARY: AddressSanitizer: SEGV (/lib/libc.so.6+0x1)\n"),
                ElementsAre("SEGV"));
}

TEST(SanitizerFindings, AreTheSameEachTime) {
    EXPECT_EQ(sanitizer_findings("a.cpp:1:1: runtime error: member call on address 0x7ffd12ab which is bad\n"),
              sanitizer_findings("a.cpp:1:1: runtime error: member call on address 0x55ee which is bad\n"));
}

TEST(SanitizerFindings, AreReportedOnceEachAndAtMostTwenty) {
    std::string errors;
    for (int i = 0; i < 100; ++i) errors += "ray_cast.cpp:1:1: runtime error: again\n";
    EXPECT_THAT(sanitizer_findings(errors), SizeIs(1));
    for (int i = 0; i < 100; ++i) errors += "ray_cast.cpp:" + std::to_string(i) + ":1: runtime error: again\n";
    EXPECT_THAT(sanitizer_findings(errors), SizeIs(20));
}

TEST(SanitizerFindings, HandleHostileText) {
    EXPECT_THAT(sanitizer_findings(""), IsEmpty());
    EXPECT_THAT(sanitizer_findings("runtime error: \n\n\n"), IsEmpty());
    EXPECT_THAT(sanitizer_findings("ERROR: AddressSanitizer: "), IsEmpty());
    EXPECT_THAT(sanitizer_findings("ERROR: AddressSanitizer: x\nray_cast.cpp:"), SizeIs(1));
    const std::string long_line(100000, 'x');
    EXPECT_LT(sanitizer_findings("a: runtime error: " + long_line).at(0).size(), 1000U);
}

/// A tier that can see nothing of /proc hides the sanitizers' options from them.
class SanitizedRun : public testing::TestWithParam<harness::Tier> {};

TEST_P(SanitizedRun, ReportsFindingsInEveryTier) {
    const harness::Sandbox sandbox(GetParam());
    if (!harness::try_canary(sandbox).held()) GTEST_SKIP() << "this machine does not hold the tier";
    const harness::StageLimits limits = harness::read_limits({}, {});
    harness::BuildSettings settings = harness::default_build_settings(limits.compile);
    for (const std::string& flag : harness::sanitizer_flags()) settings.flags.push_back(flag);
    harness::Submission submission;
    submission.source = "int main(int argc, char**) { int x = 2147483647; x += argc; return x & 0; }\n";
    const harness::Scratch scratch(sandbox.workspace());
    const harness::Build built = harness::build(submission, settings, sandbox, scratch);
    ASSERT_TRUE(built.compiled) << built.diagnostics;
    const harness::ProcessResult result =
        harness::run(built, harness::sanitizer_limits(limits.run), sandbox, scratch, harness::sanitizer_environment());
    EXPECT_THAT(harness::sanitizer_findings(result.errors), SizeIs(1)) << result.errors;
}

INSTANTIATE_TEST_SUITE_P(Tiers, SanitizedRun, testing::Values(harness::Tier::bwrap, harness::Tier::landlock),
                         [](const auto& tier) { return tier.param == harness::Tier::bwrap ? "bwrap" : "landlock"; });

}  // namespace
