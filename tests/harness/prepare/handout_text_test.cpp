#include "harness/prepare/handout_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace harness::prepare {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(HandoutText, StatesTheSceneAndEveryQuestion) {
    const std::string text = handout_text(reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS));
    EXPECT_THAT(text, HasSubstr("eye (6 1 0), lookat (0 1 0), vup (0 1 0)"));
    EXPECT_THAT(text, HasSubstr("center (2 0 0), radius R 1, height 4"));
    EXPECT_THAT(text, HasSubstr("4. **ray and cylinder** (20 points)"));
    EXPECT_THAT(text, HasSubstr("the hit point P_c"));
}

TEST(HandoutText, SaysWhatMarkingHoldsAnAnswerTo) {
    reference::Assignment assignment = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    EXPECT_THAT(handout_text(assignment), HasSubstr("at (x + 1/2)/W or x/(W - 1) of the window's width from the left"));
    EXPECT_THAT(handout_text(assignment), HasSubstr("at least 2 decimals; \"no hit\" for what is not there"));
    assignment.rubric.pixel_conventions = {reference::PixelConvention::corner};
    assignment.rubric.min_decimals = 4;
    EXPECT_THAT(handout_text(assignment), HasSubstr("at x/W of the window's width"));
    EXPECT_THAT(handout_text(assignment), HasSubstr("at least 4 decimals"));
}

TEST(HandoutText, HasWordsForEveryItem) {
    reference::Assignment assignment = reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS);
    reference::Question all{1, "everything", {}};
    for (const reference::Item& item : reference::known_items()) all.items.push_back(item.id);
    assignment.questions = {all};
    std::size_t asked = 0;
    const std::string text = handout_text(assignment);
    for (std::size_t at = text.find("   - "); at != std::string::npos; at = text.find("   - ", at + 1)) ++asked;
    EXPECT_EQ(asked, reference::known_items().size());
    EXPECT_THAT(text, Not(HasSubstr("first_hit")));
}

TEST(HandoutText, NumbersTheParts) {
    reference::Assignment assignment = reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS);
    namespace sphere = reference::item::sphere;
    assignment.questions = {
        {2, "sphere", {sphere::d, sphere::t}, {{"the discriminant", {sphere::d}}, {"", {sphere::t}}}}};
    EXPECT_THAT(handout_text(assignment), HasSubstr("2. **sphere** (20 points)\n"
                                                    "   a) the discriminant\n"
                                                    "      - its discriminant d = b^2 - 4ac\n"
                                                    "   b)\n"
                                                    "      - t of the hit"));
    assignment.rubric.item_points[2] = {{"d", 1}, {"t", 2.5}};
    EXPECT_THAT(handout_text(assignment), HasSubstr("   a) the discriminant (1 point)\n"));
    EXPECT_THAT(handout_text(assignment), HasSubstr("   b) (2.5 points)\n"));
    assignment.rubric.item_points[2] = {{"d", 1}};
    EXPECT_THAT(handout_text(assignment), HasSubstr("   b) (0 points)\n")) << "an item that is left out has none";
}

}  // namespace
}  // namespace harness::prepare
