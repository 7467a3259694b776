// From a checked assignment to its handout.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(AssignmentHandout, IsTheNextCommandAfterCheck) {
    const Result checked = raygrade({"assignment", "check", "a6-2021"});
    EXPECT_EQ(checked.status, 0) << checked.both();
    EXPECT_THAT(checked.output, testing::EndsWith("\nNext: raygrade assignment handout a6-2021 --out handout\n"));
}

TEST(AssignmentHandout, IsAPageToPrintAndMarkdownWithAPicture) {
    const TemporaryFolder folder;
    const std::string out = (folder / "handout").string();
    const Result result = raygrade({"assignment", "handout", "a6-2021", "--out", out});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr("to print: " + out + "/handout.html\n"));
    EXPECT_THAT(result.voice, HasSubstr("a6-2021 has no due date"));
    EXPECT_THAT(read(folder / "handout/handout.html"), AllOf(HasSubstr("<svg"), Not(HasSubstr("Name"))));
    EXPECT_THAT(read(folder / "handout/handout.md"), HasSubstr("](handout.svg)"));
    EXPECT_THAT(read(folder / "handout/handout.svg"), HasSubstr("<svg"));
    EXPECT_THAT(raygrade({"assignment", "handout", "a6-2021"}).output, Not(HasSubstr("](")));
}

TEST(AssignmentHandout, ReplacesAnEarlierOneOnlyIfAsked) {
    const TemporaryFolder folder;
    write(folder / "handout/handout.html", "edited by hand");
    std::vector<std::string> words{"assignment", "handout", "a6-2021", "--out", (folder / "handout").string()};
    EXPECT_EQ(raygrade(words).status, usage);
    EXPECT_EQ(read(folder / "handout/handout.html"), "edited by hand");
    words.push_back("--force");
    EXPECT_EQ(raygrade(words).status, 0);
    EXPECT_THAT(read(folder / "handout/handout.html"), HasSubstr("<svg"));
}

}  // namespace
}  // namespace scenario
