#include "harness/doctor/doctor.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <algorithm>

namespace {

using harness::MachineFinding;

MachineFinding find(const std::vector<MachineFinding>& findings, const std::string& what) {
    const auto found = std::find_if(findings.begin(), findings.end(),
                                    [&](const MachineFinding& finding) { return finding.what == what; });
    return found == findings.end() ? MachineFinding{what, MachineFinding::Level::bad, "not examined", ""} : *found;
}

TEST(ExamineMachine, FindsEverythingThatTheTestsNeed) {
    const auto findings = harness::examine_machine();
    for (const char* what : {"compiler", "compiling and running with GLM", "kernel", "cores", "programs run in"}) {
        const MachineFinding finding = find(findings, what);
        EXPECT_EQ(finding.level, MachineFinding::Level::good) << what << ": " << finding.detail;
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
        EXPECT_EQ(find(without_compiler, what).level, MachineFinding::Level::bad) << what;
    }
    EXPECT_THAT(find(without_compiler, "compiler").way_out, testing::HasSubstr("apt install g++"));
    for (const char* what : {"scratch folder", "sandbox bwrap+shim", "sandbox landlock+shim", "programs run in"}) {
        EXPECT_EQ(find(without_both, what).level, MachineFinding::Level::bad) << what;
    }
    for (const auto& finding : without_both) {
        EXPECT_EQ(finding.way_out.empty(), finding.level == MachineFinding::Level::good) << finding.what;
    }
}

TEST(WayToNamespaces, NamesWhatForbidsThem) {
    using harness::way_to_namespaces;
    using testing::HasSubstr;
    using testing::StartsWith;
    const std::string refused = "bwrap: No permissions to create new namespace";
    EXPECT_THAT(
        way_to_namespaces("bwrap: Can't mount proc on /newroot/proc: Operation not permitted", {"1", "0", "0", true}),
        testing::AllOf(StartsWith("Parts of /proc are hidden"), HasSubstr("systempaths=unconfined")));
    EXPECT_THAT(way_to_namespaces("bwrap: Unknown option --disable-userns", {"1", "0", "0", true}),
                StartsWith("This bubblewrap is too old"));
    EXPECT_THAT(way_to_namespaces(refused, {"1", "1", "9000", false}),
                HasSubstr("sysctl -w kernel.apparmor_restrict_unprivileged_userns=0"));
    EXPECT_EQ(way_to_namespaces(refused, {"0", "0", "9000", true}), "sysctl -w kernel.unprivileged_userns_clone=1");
    EXPECT_EQ(way_to_namespaces("bwrap: ... exceeded (ENOSPC)", {"", "1", "0", false}),
              "sysctl -w user.max_user_namespaces=10000");
    EXPECT_THAT(way_to_namespaces("bwrap: nesting depth or ... exceeded (ENOSPC)", {"", "1", "9000", true}),
                HasSubstr("Raise user.max_user_namespaces"));
    EXPECT_THAT(way_to_namespaces(refused, {"", "1", "9000", true}),
                testing::AllOf(StartsWith("A system call filter"), HasSubstr("seccomp=unconfined")));
    EXPECT_THAT(way_to_namespaces(refused, {"", "", "9000", false}), HasSubstr("In a chroot"));
}

}  // namespace
