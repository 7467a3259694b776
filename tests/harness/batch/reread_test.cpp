#include "harness/batch/reread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

const Marking& edge_marking() {
    static const Marking edge = make_marking(student::edge_scene().assignment);
    return edge;
}

TEST(Layout, IsTheSameForOtherNumbersAndOtherBlanks) {
    EXPECT_EQ(layout_of("t = 1.5\nhit: (1, 2, 3)\n"), layout_of("t =   -2.5e-3\nhit: (0,  nan, -inf)\n"));
    EXPECT_EQ(layout_of("t = 1"), layout_of("t = 12 \n"));
}

TEST(Layout, IsTheSameForOtherNumbersThatAreGluedToLetters) {
    EXPECT_EQ(layout_of("t1.5\n"), layout_of("t2.25e-7\n"));
    EXPECT_EQ(layout_of("x1.5y-2e-3z3m\n"), layout_of("x1y0.3z-30m\n"));
    EXPECT_EQ(layout_of("at 0x7ffe12ab, 5.\n"), layout_of("at 0x55d0, 5.25.\n"));
    EXPECT_EQ(layout_of("P.x .5 -.5\n"), layout_of("P.x 1 2\n"));
}

TEST(Layout, IsThatOfThePrintoutAsItIsRead) {
    EXPECT_EQ(layout_of("t = -1\r\n"), layout_of("t = 1\n"));
    EXPECT_EQ(layout_of("t = \xE2\x88\x92"
                        "1\n"),
              layout_of("t = 1\n"))
        << "a minus sign beyond ASCII";
    EXPECT_EQ(layout_of("\x1b[31mt\x1b[0m = 1\n"), layout_of("t = 1\n"));
    EXPECT_NE(layout_of("t = 1\rs = 2\n"), layout_of("t = 1 s = 2\n")) << "a return begins a line";
}

TEST(Layout, DiffersWhereWordsOrLinesDo) {
    EXPECT_NE(layout_of("t = 1.5\n"), layout_of("s = 1.5\n"));
    EXPECT_NE(layout_of("t = 1.5\n"), layout_of("t = none\n"));
    EXPECT_NE(layout_of("t = 1.5\n"), layout_of("\nt = 1.5\n"));
    EXPECT_NE(layout_of("1 2\n"), layout_of("1\n2\n"));
    EXPECT_NE(layout_of("t = nano\n"), layout_of("t = 1\n"));
    EXPECT_NE(layout_of("info\n"), layout_of("1o\n"));
}

/// A right printout in which t stands under a name that nobody knows, marked without and with a reread.
Graded with_unknown_label() {
    Graded graded;
    graded.printout = print(student::Program(edge_marking().assignment, {}));
    const std::size_t at = graded.printout.find("\nt");
    graded.printout.insert(at + 1, "DEBUG ");
    mark_again(graded, edge_marking());
    return graded;
}

int line_of_debug(const Graded& graded) {
    const std::string before = graded.printout.substr(0, graded.printout.find("DEBUG"));
    return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

const ItemScore& t_of(const Graded& graded) {
    return graded.score.questions.at(5).items.at(4);
}

TEST(MarkAgain, ReadsWhereTheRereadSaysAndFollowsFromThere) {
    Graded graded = with_unknown_label();
    ASSERT_EQ(t_of(graded).spec.name, "t");
    ASSERT_NE(t_of(graded).verdict, ItemVerdict::right);
    const double before = graded.score.points;
    graded.submission.rereads = {
        {6, "t", std::to_string(line_of_debug(graded)), layout_of(graded.printout), "it is t", "Ada", ""}};
    graded.score.other_scenes = ScenesScore{3, 5};
    mark_again(graded, edge_marking());
    EXPECT_EQ(t_of(graded).verdict, ItemVerdict::right);
    EXPECT_TRUE(counts(graded, graded.submission.rereads.front()));
    EXPECT_GT(graded.score.points, before + 3);
    EXPECT_EQ(graded.score.max_points, 105) << "the points for other scenes stay";
    EXPECT_TRUE(std::none_of(graded.flags.begin(), graded.flags.end(),
                             [](const Flag& flag) { return flag.evidence.find("6.t") != std::string::npos; }));
}

TEST(MarkAgain, DoesNotCountARereadForAnotherLayout) {
    Graded graded = with_unknown_label();
    graded.submission.rereads = {
        {6, "t", std::to_string(line_of_debug(graded)), layout_of("something else"), "it is t", "Ada", ""}};
    mark_again(graded, edge_marking());
    EXPECT_NE(t_of(graded).verdict, ItemVerdict::right);
    EXPECT_FALSE(counts(graded, graded.submission.rereads.front()));
}

TEST(MarkAgain, MissesAnItemThatWasNotPrinted) {
    Graded graded;
    graded.printout = print(student::Program(edge_marking().assignment, {}));
    graded.submission.rereads = {{6, "t", "", layout_of(graded.printout), "a debug line", "Ada", ""}};
    mark_again(graded, edge_marking());
    EXPECT_EQ(t_of(graded).verdict, ItemVerdict::missing);
    EXPECT_EQ(t_of(graded).reread, "Not printed, as Ada says: a debug line");
    EXPECT_FALSE(t_of(graded).doubt);
}

}  // namespace
}  // namespace harness
