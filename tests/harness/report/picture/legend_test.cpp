#include "harness/report/picture/legend.h"

#include <gtest/gtest.h>

#include "tests/given/report/drawn.h"

namespace harness::report::picture {
namespace {

TEST(Notes, AreBrokenIntoLinesThatFitTheWidth) {
    const std::string note = "The ray misses the triangle: P_t is in its plane, but outside of it.";
    const NoteLines lines = draw_notes({note, "Short."}, 150, 100);
    const auto texts = drawn::texts_in(lines.svg);
    std::string words;
    for (std::size_t i = 0; i + 1 < texts.size(); ++i) {
        EXPECT_LE(texts[i].right - texts[i].left, 150);
        words += (i == 0 ? "" : " ") + texts[i].words;
    }
    ASSERT_EQ(texts.size(), 4U);
    EXPECT_EQ(words, note);
    EXPECT_EQ(texts.back().words, "Short.");
    EXPECT_EQ(lines.bottom, 100 + 3 * line_height);
}

TEST(Notes, AreLimitedToTheRoom) {
    EXPECT_EQ(drawn::texts_in(draw_notes(std::vector<std::string>(24, "x"), 150, 100).svg).back().words, "x");
    const auto texts = drawn::texts_in(draw_notes(std::vector<std::string>(25, "x"), 150, 100).svg);
    ASSERT_EQ(texts.size(), 24U);
    EXPECT_EQ(texts.back().words, "(more notes are left out here)");
}

}  // namespace
}  // namespace harness::report::picture
