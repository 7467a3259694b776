#include "harness/prepare/check_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::prepare {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ObjectsText, SaysWhatTheRayHitsAndWhichObjectsAreNotAskedFor) {
    reference::Assignment assignment = reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS);
    const auto text = [&] { return objects_text(make_key(assignment, reference::Precision::certified)); };
    EXPECT_THAT(text(), HasSubstr("sphere hit, triangle hit, cylinder hit. First object: cylinder.\n"));
    EXPECT_THAT(text(), Not(HasSubstr("No question")));
    std::erase_if(assignment.questions, [](const reference::Question& question) {
        return std::ranges::any_of(
            question.items, [](const reference::ItemId& id) { return id.subject == reference::Subject::cylinder; });
    });
    EXPECT_THAT(text(), HasSubstr("No question asks about the cylinder. It can only be the first object.\n"));
}

}  // namespace
}  // namespace harness::prepare
