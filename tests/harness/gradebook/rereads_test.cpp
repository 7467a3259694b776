// What the gradebook keeps of printouts, and of what a person says was misread in them.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/gradebook/gradebook.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/saved_class.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

using namespace report_samples;
using namespace saved_class;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<Graded> three_with_printouts() {
    std::vector<Graded> all = three();
    all[0].execution.printout = output_with_a_mistake();
    return all;
}

std::vector<std::string> kept_printouts(const TemporaryFolder& folder) {
    std::vector<std::string> printouts;
    for (const Graded& one : Gradebook(folder.path()).restore()) printouts.push_back(one.execution.printout);
    return printouts;
}

/// As `ada` is marked once an item of hers is read from elsewhere.
Graded marked_again() {
    Graded ada = graded("ada", "Question 5:\nV: 1 2 3\n");
    ada.execution.printout = output_with_a_mistake();
    ada.score.questions.at(4).items.at(0).reread = "Read from line 3, as bea says: \"V\"";
    return ada;
}

KeptReread a_reread(const std::string& lines = "3", const std::string& why = "\"V\"") {
    return {"ada", {5, "V", lines, "abc", why, "bea", "2026-11-23T10:00:00Z"}};
}

TEST(Rereads, AreKeptThroughRunsAndAfterTheirSubmission) {
    const TemporaryFolder folder;
    const std::vector<Graded> all = three_with_printouts();
    save(folder.path(), all);
    Gradebook(folder.path()).put_reread(a_reread(), all[0], marked_again(), 0);
    for (const auto& next : {all, {all[1]}, all}) {
        save(folder.path(), next);
        const auto kept = Gradebook(folder.path()).rereads();
        ASSERT_THAT(kept, SizeIs(1));
        const auto& [submission, given] = kept[0];
        EXPECT_EQ(std::tie(submission, given.question, given.item, given.lines, given.layout),
                  std::make_tuple("ada", 5, "V", "3", "abc"));
        EXPECT_EQ(std::tie(given.why, given.by, given.when), std::make_tuple("\"V\"", "bea", "2026-11-23T10:00:00Z"));
    }
}

TEST(Rereads, ReplaceTheMarksAndTheRecord) {
    const TemporaryFolder folder;
    const std::vector<Graded> all = three_with_printouts();
    save(folder.path(), all);
    const Graded after = marked_again();
    Gradebook gradebook(folder.path());
    gradebook.put_reread(a_reread(), all[0], after, 0);
    const Graded restored = gradebook.restore().at(0);
    EXPECT_EQ(restored.score.points, after.score.points);
    EXPECT_EQ(restored.score.questions.at(4).items.at(0).reread, after.score.questions.at(4).items.at(0).reread);
    EXPECT_EQ(rows(folder, "SELECT verdict FROM items WHERE submission = 'ada' AND item = 'V'"),
              json::parse(R"([["wrong"]])"));
    EXPECT_EQ(restored.execution.printout, output_with_a_mistake());
    EXPECT_TRUE(gradebook.compare({after, all[1], all[2]}).is_as_saved());
}

TEST(Rereads, AreInTheAuditTrailWithTheMark) {
    const TemporaryFolder folder;
    const std::vector<Graded> all = three_with_printouts();
    save(folder.path(), all);
    Gradebook gradebook(folder.path());
    gradebook.put_reread(a_reread(), all[0], marked_again(), 0);
    gradebook.put_reread(a_reread("", "a debug line"), marked_again(), marked_again(), 0);
    const auto kept = gradebook.rereads();
    ASSERT_THAT(kept, SizeIs(1)) << "one for an item";
    const Author dee{"dee", "2026-11-25T10:00:00Z"};
    gradebook.remove_reread(kept[0], dee, "a slip", marked_again(), all[0], 0);
    EXPECT_THAT(gradebook.rereads(), IsEmpty());
    EXPECT_EQ(rows(folder, "SELECT who, what, before, after FROM audit WHERE entry > 1 ORDER BY entry"),
              json::parse(R"([
        ["bea", "reading of 5.V of ada", "line 12", "line 3: \"V\""],
        ["bea", "mark of ada", "98.33", "0"],
        ["bea", "reading of 5.V of ada", "line 2", "not printed: a debug line"],
        ["dee", "reading of 5.V of ada", "not printed: a debug line", "removed: a slip"],
        ["dee", "mark of ada", "0", "98.33"]])"));
    gradebook.put_reread(a_reread(), all[0], all[0], 0);
    gradebook.remove_reread(a_reread(), dee, "gone");
    EXPECT_THAT(gradebook.rereads(), IsEmpty()) << "also without its submission";
}

TEST(Printouts, BelongToTheCurrentSubmissions) {
    const TemporaryFolder folder;
    std::vector<Graded> all = three_with_printouts();
    all[1].execution.printout = std::string("a\0b\xff", 4);
    save(folder.path(), all);
    EXPECT_THAT(kept_printouts(folder), ElementsAre(output_with_a_mistake(), all[1].execution.printout, ""))
        << "any bytes";
    Graded ben = graded("ben", "Question 5:\nV: 1 2 3\n");
    save(folder.path(), {ben});
    EXPECT_EQ(rows(folder, "SELECT count(*) FROM printouts"), json::parse("[[0]]"))
        << "ada is gone, and ben's is too long to be kept";
}

TEST(Printouts, AreAddedToAGradebookOfAnOlderRaygradeWithRereads) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    SQLite::Database(file_in(folder).string(), SQLite::OPEN_READWRITE).exec("DROP TABLE printouts; DROP TABLE rereads");
    const std::vector<Graded> all = three_with_printouts();
    EXPECT_THAT(Gradebook(folder.path()).rereads(), IsEmpty());
    EXPECT_THAT(kept_printouts(folder), ElementsAre("", "", ""));
    EXPECT_FALSE(Gradebook(folder.path()).compare(all).is_as_saved()) << "the printout is new";
    save(folder.path(), all);
    EXPECT_THAT(kept_printouts(folder), ElementsAre(output_with_a_mistake(), "", ""));
    Gradebook(folder.path()).put_reread(a_reread(), all[0], marked_again(), 0);
    EXPECT_THAT(Gradebook(folder.path()).rereads(), SizeIs(1));
}

}  // namespace
}  // namespace harness
