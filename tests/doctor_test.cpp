#include "harness/doctor.h"

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

TEST(ExamineMachine, FindsEverythingThatTheTestsThemselvesNeed) {
    const auto findings = harness::examine_machine();
    for (const char* what : {"supervisor", "compiler", "compiling and running with GLM", "kernel", "cores"}) {
        const Finding finding = find(findings, what);
        EXPECT_EQ(finding.level, Finding::Level::good) << what << ": " << finding.detail;
        EXPECT_NE(finding.detail, "") << what;
        EXPECT_EQ(finding.way_out, "") << what;
    }
}

TEST(ExamineMachine, SaysWhatIsMissingInsteadOfThrowing) {
    const std::string path = getenv("PATH");
    setenv("PATH", "/nonexistent", 1);
    setenv("TMPDIR", "/nonexistent", 1);
    const auto findings = harness::examine_machine();
    setenv("PATH", path.c_str(), 1);
    unsetenv("TMPDIR");
    for (const char* what : {"compiler", "compiling and running with GLM", "scratch folder"}) {
        EXPECT_EQ(find(findings, what).level, Finding::Level::bad) << what;
    }
    EXPECT_THAT(find(findings, "compiler").detail, testing::HasSubstr("apt install g++"));
    for (const auto& finding : findings) {
        EXPECT_EQ(finding.way_out.empty(), finding.level == Finding::Level::good) << finding.what;
    }
}

}  // namespace
