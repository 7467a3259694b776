// The pages that the real raygrade writes: the class report, and each student's page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Grades a few submissions of the sample class into `out`.
Result grade_some(const fs::path& out, const std::vector<std::string>& more) {
    std::vector<std::string> words{"grade"};
    for (const char* who : {"ada", "ben", "mateo", "jin", "o'brien", "zoë"}) words.push_back(sample(who).string());
    words.insert(words.end(), {"--out", out.string()});
    words.insert(words.end(), more.begin(), more.end());
    return raygrade(words);
}

TEST(Pages, ShowRightValuesOnlyIfTheRubricAllowsIt) {
    const TemporaryFolder folder;
    ASSERT_EQ(grade_some(folder / "kept", {"--assignment", "a6-2021"}).status, 0);
    EXPECT_THAT(read(folder / "kept/feedback/ben.html"), Not(HasSubstr("0.5857")));
    EXPECT_THAT(read(folder / "kept/report.html"), HasSubstr("0.585786"));
    std::string assignment = read(project_folder() / "reference/assignments/a6-2021.toml");
    const std::string rubric = "[rubric]\n";
    ASSERT_THAT(assignment, HasSubstr(rubric));
    assignment.insert(assignment.find(rubric) + rubric.size(), "show_expected = true\n");
    write(folder / "open.toml", assignment);
    ASSERT_EQ(grade_some(folder / "open", {"--assignment", (folder / "open.toml").string()}).status, 0);
    EXPECT_THAT(read(folder / "open/feedback/ben.html"), HasSubstr("0.585786"));
}

TEST(CheckHtml, WritesThePageAndReplacesOnlyAPage) {
    const TemporaryFolder folder;
    const std::string source = (sample("ben") / "ray_cast.cpp").string();
    const std::vector<std::string> check{"check", source, "--assignment", "a6-2021", "--html"};
    const auto checked = [&](const fs::path& page) {
        std::vector<std::string> words = check;
        words.push_back(page.string());
        return raygrade(words);
    };
    EXPECT_EQ(checked(folder / "page.html").status, 0);
    const std::string page = read(folder / "page.html");
    EXPECT_THAT(page, HasSubstr("far root"));
    write(folder / "other.html", page.substr(0, 20));
    EXPECT_EQ(checked(folder / "other.html").status, 2);
    EXPECT_EQ(read(folder / "other.html"), page.substr(0, 20));
    fs::create_symlink("page.html", folder / "link.html");
    EXPECT_THAT(checked(folder / "link.html").voice, HasSubstr("name another file with --html"));
    EXPECT_EQ(checked(folder / "missing/page.html").status, 2);
    EXPECT_EQ(checked(folder / "page.html").status, 0);
    EXPECT_EQ(read(folder / "page.html"), page);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 3)
        << "nothing is left over";
}

}  // namespace
}  // namespace scenario
