// What the gradebook keeps of reviews.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/gradebook/gradebook.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/saved_class.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

using namespace report_samples;
using namespace saved_class;
using nlohmann::json;
using testing::IsEmpty;
using testing::SizeIs;

KeptDecision a_decision(Decision::Kind kind, const std::string& about, const std::string& submission = "ada") {
    Decision given;
    given.number = 1;
    given.kind = kind;
    given.about = about;
    given.seen = "line 3";
    given.text = "the reading <stands>";
    given.by = "bea";
    given.when = "2026-11-23T10:00:00Z";
    return {submission, given};
}

TEST(Decisions, AreKeptThroughRunsAndAfterTheirSubmission) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    EXPECT_EQ(Gradebook(folder.path()).next_decision(), 1);
    Gradebook(folder.path()).put_decision(a_decision(Decision::Kind::accepted, "reading_doubtful"));
    for (const auto& next : {three(), {three()[1]}, three()}) {
        save(folder.path(), next);
        const auto kept = Gradebook(folder.path()).decisions();
        ASSERT_THAT(kept, SizeIs(1));
        const auto& [submission, given] = kept[0];
        EXPECT_EQ(std::tie(submission, given.number, given.kind, given.about, given.seen),
                  std::make_tuple("ada", 1, Decision::Kind::accepted, "reading_doubtful", "line 3"));
        EXPECT_EQ(std::tie(given.text, given.by, given.when),
                  std::make_tuple("the reading <stands>", "bea", "2026-11-23T10:00:00Z"));
    }
    EXPECT_EQ(Gradebook(folder.path()).next_decision(), 2);
}

TEST(Decisions, KeepWhatTheyReplaced) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    KeptDecision points = a_decision(Decision::Kind::points, "6.t");
    points.given.replaced_override = Override{6, "t", 0.1, "\"half\"", "cy", "2026-11-22T10:00:00Z"};
    KeptDecision reading = a_decision(Decision::Kind::reading, "5.V");
    reading.given.replaced_reread = Reread{5, "V", "3-4", "abc", "\xC3\xA4", "cy", "2026-11-22T11:00:00Z"};
    Gradebook gradebook(folder.path());
    gradebook.put_decision(points);
    gradebook.put_decision(reading);
    const auto kept = gradebook.decisions();
    ASSERT_THAT(kept, SizeIs(2));
    const Override& half = kept[0].given.replaced_override.value();
    EXPECT_EQ(std::tie(half.points, half.why, half.when), std::make_tuple(0.1, "\"half\"", "2026-11-22T10:00:00Z"));
    const Reread& earlier = kept[1].given.replaced_reread.value();
    EXPECT_EQ(std::tie(earlier.lines, earlier.layout, earlier.why), std::make_tuple("3-4", "abc", "\xC3\xA4"));
}

TEST(Decisions, AreNotRemovedWhenTheyAreUndone) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    Gradebook gradebook(folder.path());
    gradebook.put_decision(a_decision(Decision::Kind::comment, ""));
    gradebook.put_decision(a_decision(Decision::Kind::comment, "", "ben"));
    gradebook.undo_decision(a_decision(Decision::Kind::comment, ""), {"dee", "2026-11-24T10:00:00Z"});
    ASSERT_THAT(gradebook.decisions(), SizeIs(1));
    EXPECT_EQ(gradebook.decisions()[0].submission, "ben");
    const auto undone = gradebook.undone_decisions();
    ASSERT_THAT(undone, SizeIs(1));
    const auto& [made, by] = undone[0];
    EXPECT_EQ(std::tie(made.submission, made.given.number, made.given.text, by.name, by.when),
              std::make_tuple("ada", 1, "the reading <stands>", "dee", "2026-11-24T10:00:00Z"));
    EXPECT_EQ(rows(folder, "SELECT undone_at, undone_by FROM decisions ORDER BY submission"),
              json::parse(R"([["2026-11-24T10:00:00Z", "dee"], [null, null]])"));
    EXPECT_EQ(rows(folder, "SELECT who, what, before, after FROM audit WHERE what LIKE 'decision%' ORDER BY entry"),
              json::parse(R"([["bea", "decision 1: comment of ada", null, "the reading <stands>"],
                              ["bea", "decision 1: comment of ben", null, "the reading <stands>"],
                              ["dee", "decision 1: comment of ada", "the reading <stands>", "undone"]])"));
}

TEST(Decisions, MadeTogetherAreAllSavedOrNone) {
    const TemporaryFolder folder;
    save(folder.path(), three());
    Gradebook gradebook(folder.path());
    const auto version = gradebook.version();
    const KeptOverride one{"ada", {6, "t", 1, "why", "bea", "2026-11-23T10:00:00Z"}};
    EXPECT_THROW(gradebook.together([&] {
        gradebook.put_override(one, 0, 1);
        gradebook.put_decision(a_decision(Decision::Kind::points, "6.t"));
        throw std::runtime_error("a second submission can't be changed");
    }),
                 std::runtime_error);
    EXPECT_THAT(gradebook.overrides(), IsEmpty());
    EXPECT_THAT(gradebook.decisions(), IsEmpty());
    EXPECT_EQ(gradebook.version(), version);
    gradebook.together([&] { gradebook.put_override(one, 0, 1); });
    EXPECT_THAT(Gradebook(folder.path()).overrides(), SizeIs(1));
    EXPECT_NE(gradebook.version(), version);
}

}  // namespace
}  // namespace harness
