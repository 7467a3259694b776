#include "harness/results/reports.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/gradebook/gradebook.h"
#include "harness/machine/errors.h"
#include "harness/machine/fresh_file.h"
#include "tests/given/bytes_of.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

using namespace report_samples;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// The contents of every file below a folder, by name.
std::map<std::string, std::string> files_of(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = bytes_of(entry.path());
    }
    return files;
}

constexpr const char* exported = "Student,ID,Assignment 6 (71)\r\nAda,ada,\r\nBob,bob,\r\n";

/// Three submissions: ada, late and with an override; a hostile one; and bob, not graded but with an overridden total.
std::vector<Graded> a_class() {
    std::vector<Graded> all = {graded("ada", output_with_a_mistake()), hostile(), not_graded("bob")};
    all[0].late_share = 0.25;
    return all;
}
const std::vector<KeptOverride> overrides = {{"ada", {6, "t", 1.5, "right idea", "bea", "2026-11-22T09:30:00Z"}},
                                             {"bob", {0, "", 40, "by hand", "bea", "2026-11-22T09:31:00Z"}}};

class ClassReports : public testing::Test {
  protected:
    fs::path write(const std::string& name, const std::vector<Graded>& all, std::optional<std::size_t> only = {}) {
        const fs::path out = folder.path() / name;
        make_folder(out, "feedback");
        write_reports({all, marking(), Tier::bwrap, report::read_canvas_roster(exported, ""), std::nullopt}, out, only);
        return out;
    }
    TemporaryFolder folder;
};

TEST_F(ClassReports, RemoveFeedbackOfRemovedStudentsAndImportsWithoutARoster) {
    const fs::path out = write("out", a_class());
    folder.write("out/feedback/mine.txt", "mine");
    write_reports({{}, marking(), Tier::bwrap, std::nullopt, std::nullopt}, out);
    EXPECT_FALSE(fs::exists(out / "feedback/ada.md"));
    EXPECT_TRUE(fs::exists(out / "feedback/mine.txt"));
    EXPECT_FALSE(fs::exists(out / "grades-canvas.csv"));
}

TEST_F(ClassReports, RemoveWhatAKilledCommandLeftUnfinished) {
    const fs::path out = write("out", a_class());
    const auto files = files_of(out);
    folder.write("out/feedback/ada.md.raygrade-new", "half of it");
    write("out", a_class());
    EXPECT_EQ(files_of(out), files);
}

TEST_F(ClassReports, RewriteOnlyTheFeedbackOfAChangedSubmission) {
    std::vector<Graded> all = a_class();
    const fs::path out = write("out", all);
    folder.write("out/feedback/bob.md", "as it was");
    attach(overrides, all);
    write("out", all, 0);
    EXPECT_EQ(bytes_of(out / "feedback/bob.md"), "as it was");
    EXPECT_THAT(bytes_of(out / "feedback/ada.md"), HasSubstr("right idea"));
    EXPECT_THAT(bytes_of(out / "grades.json"), HasSubstr("right idea"));
}

TEST(FeedbackName, HasNoSlashAndFitsAFileName) {
    EXPECT_EQ(feedback_name("2021/s01", 3), "2021%2Fs01");
    EXPECT_EQ(feedback_name("2021%2Fs01", 3), "2021%252Fs01") << "another student's page";
    EXPECT_NE(feedback_name("2021%252Fs01", 3), feedback_name("2021%2Fs01", 3));
    EXPECT_EQ(feedback_name("a%0Ab", 3), "a%0Ab");
    EXPECT_EQ(feedback_name(std::string(300, 'x'), 3), std::string(200, 'x') + "-4");
    EXPECT_EQ(feedback_name(std::string(199, 'x') + "éé", 3), std::string(199, 'x') + "-4") << "no half character";
}

TEST(ResultsFolder, IsNotSharedByTwoCommandsAtOnce) {
    const TemporaryFolder folder;
    const fs::path out = folder.make_folder("out");
    {
        const FolderLock lock(out);
        EXPECT_THROW(FolderLock{out}, UsageError);
    }
    EXPECT_NO_THROW(FolderLock{out});
    EXPECT_NO_THROW(FolderLock{folder.path() / "missing"});
}

TEST(ResultsFolder, MustBeNewOrEmptyOrOfAnEarlierRun) {
    const TemporaryFolder folder;
    const auto look = [&](const char* name) { return look_into(folder.path() / name, marks_of_results(), "feedback"); };
    EXPECT_EQ(look("missing"), Holds::nothing);
    folder.make_folder("begun/feedback");
    EXPECT_EQ(look("begun"), Holds::nothing);
    folder.write("older/grades.json", "{}");
    EXPECT_EQ(look("older"), Holds::earlier_results);
    folder.write("killed/gradebook.sqlite", "");
    EXPECT_EQ(look("killed"), Holds::earlier_results);
    folder.make_folder("killed-at-once/feedback");
    folder.write("killed-at-once/grades.json.raygrade-new", "");
    EXPECT_EQ(look("killed-at-once"), Holds::earlier_results);
    folder.write("mine/thesis.txt", "mine");
    EXPECT_THROW(look("mine"), UsageError);
    folder.write("file", "mine");
    EXPECT_THROW(look("file"), UsageError);
}

}  // namespace
}  // namespace harness
