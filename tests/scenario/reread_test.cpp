// An instructor corrects what was misread, and the marks follow from it.
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

/// Answers question 5 rightly under a label that says that it is no answer; `words` may change the layout.
std::string program(const std::string& numbers, const std::string& words = "old dir") {
    return "#include <cstdio>\nint main() { puts(\"Question 5:\\n" + words + ": vec3(" + numbers + ")\"); }\n";
}

class Reread : public testing::Test {
  protected:
    Reread() {
        fs::permissions(folder.path(), static_cast<fs::perms>(0755));
        write(student("ada"), program("0.000000, 0.000000, -1.000000"));
        write(student("ben"), program("0.500000, 0.000000, -1.000000"));
        write(student("cy"), program("0.000000, 0.000000, -1.000000", "V"));
        grade();
    }

    fs::path student(const std::string& id) const { return folder / "class" / id / "ray_cast.cpp"; }
    Result run(std::vector<std::string> words) const { return raygrade(words, with_cache(folder / "cache")); }
    Result grade() const {
        return run({"grade", (folder / "class").string(), "--out", (folder / "out").string(), "--apply"});
    }
    Result reread(const std::vector<std::string>& more) const {
        std::vector<std::string> words = {"reread", "--results", (folder / "out").string()};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    json graded(const std::string& id) const { return submission_in(read_json(folder / "out" / "grades.json"), id); }
    double points(const std::string& id) const { return graded(id).at("points").get<double>(); }

    TemporaryFolder folder;
};

TEST_F(Reread, MarksTheGivenLineAndSurvivesRegrades) {
    ASSERT_EQ(points("ada"), 0);
    const Result done = reread({"ada", "5.V", "2", "--why", "dir is V", "--by", "Prof. X"});
    ASSERT_EQ(done.status, 0) << done.both();
    EXPECT_THAT(done.output, AllOf(HasSubstr("5.V: missing -> "), HasSubstr("ada: 0 -> 10 of 100 points in total")));
    EXPECT_THAT(done.output, HasSubstr("These have the same layout: ben. To reread them too, add --alike."));
    EXPECT_EQ(points("ada"), 10);
    EXPECT_THAT(graded("ada").dump(), HasSubstr("Read from line 2, as Prof. X says: dir is V"));
    EXPECT_THAT(graded("ada").dump(), Not(HasSubstr("reading_doubtful\",\"evidence\":\"5.V")));
    EXPECT_THAT(read(folder / "out/feedback/ada.md"), HasSubstr("Read from line 2, as your instructor says: dir is V"));
    EXPECT_THAT(read(folder / "out/feedback/ada.html"),
                HasSubstr("Read from line 2, as your instructor says: dir is V"));

    EXPECT_THAT(grade().both(), HasSubstr("Nothing has changed"));
    write(student("ada"), program("0.000000, 0.000000, -1.000") + "// again\n");
    const Result again = grade();
    EXPECT_EQ(points("ada"), 10) << "the same layout: " << again.both();
    EXPECT_THAT(again.voice, Not(HasSubstr("is unused")));
}

TEST_F(Reread, OfAlikeOutputsIsRemovedByOneCommand) {
    ASSERT_EQ(reread({"ada", "5.V", "2", "--why", "dir is V", "--alike"}).status, 0);
    ASSERT_EQ(reread({"cy", "5.V", "--none", "--why", "another layout"}).status, 0);
    const Result back = reread({"ben", "5.V", "--remove", "--alike", "--why", "it is not"});
    EXPECT_THAT(back.output, AllOf(HasSubstr("ada: 10 -> 0"), HasSubstr("ben 5.V"), Not(HasSubstr("cy"))));
    EXPECT_EQ(points("ada"), 0);
    EXPECT_THAT(reread({"--list"}).output, AllOf(HasSubstr("cy  5.V"), Not(HasSubstr("ada")), Not(HasSubstr("ben"))));
    EXPECT_THAT(read(folder / "out/feedback/ben.md"), Not(HasSubstr("Read from")));
}

TEST_F(Reread, RefusesALineThatItCannotRead) {
    const auto refusal = [&](const std::vector<std::string>& words) {
        const Result result = reread(words);
        EXPECT_EQ(result.status, usage) << result.both();
        return result.voice;
    };
    EXPECT_THAT(refusal({"ada", "5.V", "1", "--why", "x"}), HasSubstr("a vector of three numbers is needed for 5.V"));
    EXPECT_THAT(refusal({"ada", "5.V", "1", "--why", "x"}), HasSubstr("line 1 has 0 numbers, but"));
    EXPECT_THAT(refusal({"ada", "5.V", "2:3", "--why", "x"}), HasSubstr("line 2 has 3 numbers, but"));
    EXPECT_THAT(refusal({"ada", "5.V", "9", "--why", "x"}), HasSubstr("the output has only 2 lines"));
    EXPECT_THAT(refusal({"ada", "5.V", "x", "--why", "x"}), HasSubstr("write 12, 12-14"));
    EXPECT_THAT(refusal({"ada", "5", "2", "--why", "x"}), HasSubstr("is not a single item"));
    EXPECT_THAT(refusal({"ada", "5.v", "2", "--why", "x"}), HasSubstr("5.V"));
    EXPECT_THAT(refusal({"ad", "5.V", "2", "--why", "x"}), HasSubstr("ada"));
    EXPECT_THAT(refusal({"ada", "5.V", "2"}), HasSubstr("needs a reason"));
    EXPECT_THAT(refusal({"ada", "5.V", "--why", "x"}), HasSubstr("lines of its output or --none"));
    EXPECT_THAT(refusal({"ada", "5.V", "--remove", "--why", "x"}), HasSubstr("has no reread of"));
    EXPECT_EQ(points("ada"), 0);
}

}  // namespace
}  // namespace scenario
