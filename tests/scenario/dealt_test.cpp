// A scene for each student, from the roster to the marks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/scenario/scenario.h"

namespace scenario {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Dealt : public testing::Test {
  protected:
    Dealt() {
        write(folder / "class.csv", "id,name\nada,Ada Lovelace\nben,Ben\n");
        const Result result = deal("a6-2024", "class.csv", "dealt");
        EXPECT_EQ(result.status, 0) << result.both();
    }

    Result deal(const std::string& from, const std::string& roster, const std::string& out) const {
        return raygrade({"assignment", "deal", from, (folder / roster).string(), "--out", (folder / out).string()});
    }
    std::string file() const { return (folder / "dealt/a6-2024.toml").string(); }

    /// A program that prints what is right for this student.
    void hand_in(const std::string& who, const std::string& answers_of) const {
        const Result right = raygrade({"reference", "--assignment", file() + "@" + answers_of});
        EXPECT_EQ(right.status, 0) << right.voice;
        write(folder / "class" / who / "ray_cast.cpp",
              "#include <cstdio>\nint main() { std::puts(R\"~(" + right.output + ")~\"); }\n");
    }
    Result grade(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"grade", (folder / "class").string(), "--assignment", file(),
                                       "--out", (folder / "out").string()};
        words.insert(words.end(), more.begin(), more.end());
        return raygrade(words);
    }

    TemporaryFolder folder;
};

TEST_F(Dealt, ScenesHaveHandoutsAndAreKeptForLatecomers) {
    const std::string ada = read(folder / "dealt/handouts/ada.md"), ben = read(folder / "dealt/handouts/ben.md");
    EXPECT_THAT(ada, HasSubstr("ray and cylinder"));
    EXPECT_NE(ada, ben);
    EXPECT_THAT(ada, AllOf(HasSubstr("**Name:** Ada Lovelace (ada)"), HasSubstr("](ada.svg)")));
    EXPECT_THAT(read(folder / "dealt/handouts/ada.html"), AllOf(HasSubstr("Ada Lovelace (ada)"), HasSubstr("<svg")));
    EXPECT_THAT(read(folder / "dealt/handouts/ada.svg"), HasSubstr("<svg"));
    EXPECT_THAT(raygrade({"assignment", "handout", file() + "@ada"}).output, HasSubstr("**Name:** ada\n"));
    write(folder / "more.csv", "id,name\nada,Ada Lovelace\nben,Ben\ncy,\n");
    EXPECT_THAT(deal(file(), "more.csv", "again").voice, HasSubstr("students with their own scene: 3, 1 of them new"));
    EXPECT_EQ(read(folder / "again/handouts/ada.md"), ada);
    EXPECT_NE(read(folder / "again/handouts/cy.md"), ada);
    const Result over = deal("a6-2024", "class.csv", "dealt");
    EXPECT_EQ(over.status, usage) << "scenes that students work on are not replaced";
    EXPECT_THAT(over.voice, HasSubstr("name a new folder with --out"));
    EXPECT_EQ(read(folder / "dealt/handouts/ada.md"), ada);
}

TEST_F(Dealt, SubmissionsAreGradedWithTheirOwnScene) {
    hand_in("ada", "ada");
    hand_in("ben", "ada");
    hand_in("zoe", "ada");
    const Result result = grade();
    EXPECT_THAT(result.voice, Not(HasSubstr("no submission from")));
    EXPECT_EQ(result.status, some_not_graded) << result.both();
    const json grades = read_json(folder / "out/grades.json");
    EXPECT_EQ(submission_in(grades, "ada").at("points"), 100);
    EXPECT_LT(submission_in(grades, "ben").at("points"), 100);
    EXPECT_THAT(submission_in(grades, "ben").at("flags").dump(), HasSubstr("scene_of_another"));
    EXPECT_THAT(result.voice, HasSubstr("ben: the answers are right for another scene, that of ada"));
    EXPECT_EQ(submission_in(grades, "zoe").at("outcome"), "not_graded");
    EXPECT_THAT(read(folder / "out/feedback/zoe.md"), Not(HasSubstr("ada"))) << "who else is in the class";
    EXPECT_NE(submission_in(grades, "ada").at("questions").at(0).at("items").at(0).at("expected"),
              submission_in(grades, "ben").at("questions").at(0).at("items").at(0).at("expected"));
    EXPECT_THAT(grade().output, HasSubstr("3 stay as they are"));

    const std::string before = read(folder / "out/feedback/ada.html");
    const Result corrected =
        raygrade({"override", "ada", "total", "90", "--why", "late talk", "--results", (folder / "out").string()});
    EXPECT_EQ(corrected.status, 0) << corrected.both();
    EXPECT_NE(read(folder / "out/feedback/ada.html"), before);
    EXPECT_EQ(submission_in(read_json(folder / "out/grades.json"), "ada").at("questions").at(0).at("verdict"), "right");
}

TEST_F(Dealt, StudentsWithoutASubmissionAreNamed) {
    hand_in("ben", "ben");
    EXPECT_THAT(grade().voice, HasSubstr("no submission from these students with their own scene: ada"));
}

TEST_F(Dealt, ScenesAreNamedWhereOneIsNeeded) {
    hand_in("ada", "ada");
    const std::string source = (folder / "class/ada/ray_cast.cpp").string();
    EXPECT_THAT(raygrade({"check", source, "--assignment", file() + "@ada"}).output, HasSubstr("100 of 100"));
    EXPECT_THAT(raygrade({"check", source, "--assignment", file()}).voice, HasSubstr("choose a student"));
    EXPECT_THAT(raygrade({"check", source, "--assignment", file() + "@adda"}).voice, HasSubstr("did you mean ada"));
    EXPECT_EQ(grade({"--variants", "2"}).status, usage);
    const Result of_class = raygrade({"grade", source, "--assignment", file() + "@ada"});
    EXPECT_EQ(of_class.status, usage);
    EXPECT_THAT(of_class.voice, HasSubstr("this command needs the whole assignment: " + file()));
    const Result page = raygrade({"serve", "--assignment", file()});
    EXPECT_EQ(page.status, usage);
    EXPECT_THAT(page.voice, HasSubstr("does not know whose program it marks"));
}

}  // namespace
}  // namespace scenario
