// `raygrade explain` as a person runs it: what it reads and writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* far_root = "Question 6: hit point: (0, 0, -1.41421)\n";

TEST(Explain, WritesAPictureAndSaysWhere) {
    const TemporaryFolder folder;
    const fs::path file = folder / "scene.svg";
    const Result result = raygrade({"explain", "--assignment", "a6-2021", "-o", file.string()});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, HasSubstr(file.string()));
    EXPECT_THAT(read(file), StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_THAT(read(file), ContainsRegex(">[0-9]+ P_s</text>"));
}

TEST(Explain, DrawsTheAnswersOfATranscript) {
    const TemporaryFolder folder;
    write(folder / "output.txt", far_root);
    const Result result = raygrade({"explain", (folder / "output.txt").string(), "-o", "-"});
    EXPECT_EQ(result.status, 0) << result.both();
    EXPECT_THAT(result.output, StartsWith("<svg "));
    EXPECT_THAT(result.output, HasSubstr("printed P_s"));
    EXPECT_THAT(result.output, HasSubstr("t = 0.5858"));
    std::string utf_16 = "\xff\xfe";  // as PowerShell writes it
    for (const char c : std::string(far_root)) utf_16 += {c, '\0'};
    write(folder / "utf-16.txt", utf_16);
    EXPECT_EQ(raygrade({"explain", (folder / "utf-16.txt").string(), "-o", "-"}).output, result.output);
    const Result for_student = raygrade({"explain", (folder / "output.txt").string(), "--without-answers", "-o", "-"});
    EXPECT_EQ(for_student.status, 0) << for_student.both();
    EXPECT_THAT(for_student.output, HasSubstr("printed P_s"));
    EXPECT_THAT(for_student.output, Not(HasSubstr("0.5858")));
    EXPECT_THAT(for_student.output, Not(ContainsRegex(">[0-9]+ P_s</text>")));
}

}  // namespace
}  // namespace scenario
