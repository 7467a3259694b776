#include "harness/run/doctor.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <algorithm>

namespace {

using harness::Finding;

Finding find(const std::vector<Finding>& findings, const std::string& what) {
    const auto found =
        std::find_if(findings.begin(), findings.end(), [&](const Finding& finding) { return finding.what == what; });
    return found == findings.end() ? Finding{what, Finding::Level::bad, "not examined", ""} : *found;
}

TEST(ExamineMachine, FindsEverythingThatTheTestsNeed) {
    const auto findings = harness::examine_machine();
    for (const char* what : {"compiler", "compiling and running with GLM", "kernel", "cores", "programs run in"}) {
        const Finding finding = find(findings, what);
        EXPECT_EQ(finding.level, Finding::Level::good) << what << ": " << finding.detail;
        EXPECT_NE(finding.detail, "") << what;
        EXPECT_EQ(finding.way_out, "") << what;
    }
}

TEST(ExamineMachine, ReportsMissingPartsInsteadOfThrowing) {
    const std::string path = getenv("PATH");
    setenv("PATH", "/nonexistent", 1);
    const auto without_compiler = harness::examine_machine();
    setenv("TMPDIR", "/nonexistent", 1);
    const auto without_both = harness::examine_machine();
    setenv("PATH", path.c_str(), 1);
    unsetenv("TMPDIR");
    for (const char* what : {"compiler", "compiling and running with GLM"}) {
        EXPECT_EQ(find(without_compiler, what).level, Finding::Level::bad) << what;
    }
    EXPECT_THAT(find(without_compiler, "compiler").way_out, testing::HasSubstr("apt install g++"));
    for (const char* what : {"scratch folder", "sandbox bwrap+shim", "sandbox landlock+shim", "programs run in"}) {
        EXPECT_EQ(find(without_both, what).level, Finding::Level::bad) << what;
    }
    for (const auto& finding : without_both) {
        EXPECT_EQ(finding.way_out.empty(), finding.level == Finding::Level::good) << finding.what;
    }
}

}  // namespace
