// The class under review follows its gradebook, which other commands change meanwhile.
#include "harness/review/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/bytes_of.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/saved_class.h"
#include "tests/given/temporary_folder.h"

namespace harness::review {
namespace {

using namespace report_samples;
using testing::ElementsAre;

/// The assignment with a scene for each of these students.
std::string dealt_to(const std::vector<std::string>& students) {
    std::string toml = bytes_of(RAYGRADE_PROJECT "/reference/assignments/a6-2021.toml");
    int row = 100;
    for (const std::string& student : students)
        toml += "\n[[student]]\nid = \"" + student + "\"\nwindow.pixel = [150, " + std::to_string(++row) + "]\n";
    return toml;
}

/// Grades the class into the folder, as `raygrade grade --apply` does.
void grade(const TemporaryFolder& folder, const std::vector<Graded>& all, const std::string& toml = dealt_to({})) {
    Gradebook gradebook(folder.path());
    Run run = saved_class::a_run();
    run.toml = toml;
    gradebook.save(run, all, gradebook.compare(all), {});
}

std::vector<std::string> ids_in(const Session& session) {
    std::vector<std::string> ids;
    for (const Graded& one : session.graded()) ids.push_back(one.submission.id);
    return ids;
}

TEST(Session, GradesALatecomerByTheSceneDealtToTheirName) {
    const TemporaryFolder folder;
    const Graded ada = graded("ada", "");
    Graded rick = graded("roerick", "");
    rick.submission.lms.emplace().student = "Rick Roe";
    const std::string toml = dealt_to({"ada", "Rick Roe"});
    grade(folder, {ada}, toml);
    Session session(folder.path(), "bea");
    const Marking* const adas = &own_marking(session.marking(), ada.submission);
    grade(folder, {ada, rick}, toml);
    session.refresh();
    EXPECT_EQ(own_marking(session.marking(), rick.submission).assignment.scene.pixel.y, 102);
    EXPECT_EQ(&own_marking(session.marking(), ada.submission), adas) << "the keys are not made again";
    grade(folder, {ada, rick}, dealt_to({"Rick Roe"}));
    session.refresh();
    EXPECT_EQ(own_marking(session.marking(), rick.submission).assignment.scene.pixel.y, 101);
}

TEST(Session, ReadsAGradebookThatWasMadeAgain) {
    const TemporaryFolder folder;
    grade(folder, {graded("ada", ""), graded("ben", "")});
    Session session(folder.path(), "bea");
    std::filesystem::remove(saved_class::file_in(folder));
    grade(folder, {graded("ada", ""), graded("cy", "")});
    session.refresh();
    EXPECT_THAT(ids_in(session), ElementsAre("ada", "cy"));
}

TEST(Session, KeepsItsClassWhileTheGradebookCantBeRead) {
    const TemporaryFolder folder;
    const std::filesystem::path file = saved_class::file_in(folder), away = folder.path() / "away";
    grade(folder, {graded("ada", ""), graded("ben", "")});
    Session session(folder.path(), "bea");
    std::filesystem::rename(file, away);
    EXPECT_THROW(session.refresh(), UsageError);
    EXPECT_THAT(ids_in(session), ElementsAre("ada", "ben"));
    EXPECT_EQ(session.marking().assignment.scene.pixel.x, 150);
    std::filesystem::rename(away, file);
    session.refresh();
    EXPECT_THAT(ids_in(session), ElementsAre("ada", "ben"));
}

TEST(Session, ForgetsWhatAFailedChangeDid) {
    const TemporaryFolder folder;
    grade(folder, {graded("ada", "")});
    Session session(folder.path(), "bea");
    const auto fail = [](Gradebook&, KeptClass& kept) -> std::vector<std::size_t> {
        kept.graded.clear();
        throw UsageError("no");
    };
    EXPECT_THROW(session.change(fail), UsageError);
    session.refresh();
    EXPECT_THAT(ids_in(session), ElementsAre("ada"));
}

}  // namespace
}  // namespace harness::review
