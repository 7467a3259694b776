// Compares a new grading of a class with the grading in its gradebook.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "harness/gradebook/gradebook.h"
#include "harness/machine/errors.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/saved_class.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

using namespace report_samples;
using namespace saved_class;
using namespace std::chrono_literals;
using nlohmann::json;
using testing::ElementsAre;
using testing::SizeIs;

using Record = Gradebook::Comparison::Record;

TEST(Gradebook, WritesOnlyChangedSubmissions) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    std::vector<Graded> all = three();
    all[1].execution.build.wall = 5ms;
    all[2] = graded("cy", "Question 5:\nV: 1 2 3\n");
    std::swap(all[0], all[2]);
    const auto comparison = save(folder.path(), all);
    EXPECT_THAT(comparison.records, ElementsAre(Record::other_marks, Record::other, Record::same));
    EXPECT_EQ(comparison.changes.untouched, 2U) << "how long the compiler took is no change";
    EXPECT_THAT(comparison.changes.rising, SizeIs(1));
    EXPECT_EQ(rows(folder, "SELECT id, run FROM submissions ORDER BY place"),
              json::parse(R"([["cy", 2], ["ben", 2], ["ada", 1]])"));
    EXPECT_EQ(rows(folder, "SELECT submission, run FROM history ORDER BY run, submission"),
              json::parse(R"([["ada", 1], ["ben", 1], ["cy", 1], ["cy", 2]])"));
    EXPECT_EQ(Gradebook(folder.path()).restore().at(1).execution.build.wall, 5ms);
}

TEST(Gradebook, KnowsWhetherAClassEqualsTheSavedClass) {
    const TemporaryFolder folder;
    const auto is_as_saved = [&](const std::vector<Graded>& all) {
        return Gradebook(folder.path()).compare(all).is_as_saved();
    };
    EXPECT_FALSE(is_as_saved(three()));
    save(folder.path(), three());
    EXPECT_TRUE(is_as_saved(three()));
    EXPECT_FALSE(is_as_saved({three()[0], three()[1]})) << "one is gone";
    EXPECT_FALSE(is_as_saved({three()[1], three()[0], three()[2]})) << "in another order";
    std::vector<Graded> other = three();
    other[1].execution.build.wall = 5ms;
    EXPECT_FALSE(is_as_saved(other));
    std::vector<Graded> moved = three();
    for (Graded& one : moved) one.submission.file = "submissions (1).zip" / one.submission.file.filename();
    EXPECT_TRUE(is_as_saved(moved)) << "the folder or the archive has another name";
    moved[0].submission.file = "submissions (1).zip/other.cpp";
    EXPECT_FALSE(is_as_saved(moved));
    other = three();
    other.push_back(graded("dan", "Question 5:\n"));
    EXPECT_FALSE(is_as_saved(other)) << "one is new";
}

TEST(Gradebook, RefusesARunThatWasComparedWithAnOlderOne) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    Gradebook slow(folder.path());
    const auto comparison = slow.compare(three());
    save(folder.path(), {three()[0]});
    EXPECT_THROW(slow.save(a_run(), three(), comparison, {}), HarnessError);
    EXPECT_EQ(rows(folder, "SELECT id FROM submissions"), json::parse(R"([["ada"]])"));
    EXPECT_EQ(rows(folder, "SELECT COUNT(*) FROM runs"), json::parse("[[2]]"));
}

}  // namespace
}  // namespace harness
