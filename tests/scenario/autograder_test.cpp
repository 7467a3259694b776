// What `raygrade autograder` writes and refuses. tests/checks/gradescope_autograder and classroom50_autograder run it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

class Autograder : public testing::Test {
  protected:
    Result gradescope(const std::string& assignment, std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"autograder", "gradescope", "--assignment", assignment, "--out", zip().string()});
        return raygrade(more);
    }
    Result classroom50(const std::string& assignment, std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"autograder", "classroom50", "--assignment", assignment, "--out", out().string(),
                                   "--image", "ghcr.io/my-course/raygrade:1"});
        return raygrade(more);
    }
    /// The assignment of 2021 with these lines added.
    std::string assignment_with(const std::string& lines) const {
        write(folder / "mine.toml", read(project_folder() / "reference/assignments/a6-2021.toml") + "\n" + lines);
        return (folder / "mine.toml").string();
    }
    fs::path zip() const { return folder / "autograder.zip"; }
    fs::path out() const { return folder / "autograder"; }

    TemporaryFolder folder;
};

TEST_F(Autograder, RefusesAnAssignmentThatGradingWouldRefuse) {
    for (const auto& [lines, words] :
         {std::pair{"[limits.run]\ncpu_secs = 1\n", "cpu_secs"},
          {"[[rubric.mistake]]\nname = \"no such mistake\"\npoints = 1\n", "mine.toml"},
          {"[[student]]\nid = \"s07\"\n", "an autograder does not know whose submission it grades"}}) {
        const Result refused = gradescope(assignment_with(lines));
        EXPECT_EQ(refused.status, usage) << lines << refused.both();
        EXPECT_THAT(refused.voice, HasSubstr(words));
        EXPECT_FALSE(fs::exists(zip()));
        EXPECT_EQ(classroom50(assignment_with(lines)).status, usage) << lines;
        EXPECT_FALSE(fs::exists(out()));
    }
}

TEST_F(Autograder, ReplacesOnlyAnEarlierOneAndOnlyIfForced) {
    EXPECT_EQ(gradescope("a6-2021").status, 0);
    const std::string first = read(zip());
    const Result kept = gradescope("a6-edge");
    EXPECT_EQ(kept.status, usage);
    EXPECT_THAT(kept.voice, HasSubstr("--force"));
    EXPECT_EQ(read(zip()), first);
    EXPECT_EQ(gradescope("a6-edge", {"--force"}).status, 0);
    EXPECT_NE(read(zip()), first);
    write(zip(), "a student's own zip? no");
    EXPECT_THAT(gradescope("a6-2021", {"--force"}).voice, HasSubstr("is not a zip"));
    EXPECT_EQ(read(zip()), "a student's own zip? no");

    EXPECT_EQ(classroom50("a6-2021").status, 0);
    EXPECT_THAT(classroom50("a6-edge").voice, HasSubstr("--force"));
    EXPECT_EQ(classroom50("a6-edge", {"--force"}).status, 0);
    EXPECT_TRUE(fs::exists(out() / "assignment/a6-edge.toml"));
    EXPECT_FALSE(fs::exists(out() / "assignment/a6-2021.toml")) << "the script would not know which";
}

TEST_F(Autograder, NeverWritesIntoAForeignFolder) {
    write(out() / "thesis.tex", "precious");
    EXPECT_EQ(classroom50("a6-2021", {"--force"}).status, usage);
    EXPECT_FALSE(fs::exists(out() / "autograder.py"));
}

TEST_F(Autograder, SaysInFilesWhatToRunAndInWhichImage) {
    EXPECT_EQ(classroom50("a6-2021", {"--variants", "2"}).status, 0);
    EXPECT_EQ(read(out() / "options"), "--variants\n2\n--variant-seed\n1\n");
    const auto runtime = read_json(out() / "runtime.json");
    EXPECT_EQ(runtime.at("container").at("image"), "ghcr.io/my-course/raygrade:1");
    EXPECT_EQ(runtime.at("container").at("user"), "root");
}

}  // namespace
}  // namespace scenario
