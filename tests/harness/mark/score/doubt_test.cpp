#include "harness/mark/score/doubt.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/mark/score/doubts_text.h"
#include "harness/mark/score/mark_transcript.h"
#include "tests/given/printed_values.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/program.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

const student::Marking& off_axis() {
    static const student::Marking marking = student::off_axis_scene();
    return marking;
}

Score marked(const std::string& output) {
    return score(read_transcript(output, 10), off_axis().key, off_axis().assignment);
}

std::optional<Doubt> doubt_of(const std::string& output, const reference::ItemId& id) {
    const Score score = marked(output);
    return item_of(score, id).doubt;
}

// The right ray parameter of the sphere is 2.29988, P_s is (3.62297, 0.37245, 0.73491).

TEST(Doubt, IsNotRaisedForARightAnswer) {
    EXPECT_FALSE(doubt_of("Question 6:\nt: 2.29988\nother: 7.77\n", reference::item::sphere::t));
}

TEST(Doubt, IsNotRaisedIfAllIsUnderstood) {
    EXPECT_FALSE(doubt_of("Question 6:\nt: 3.29988\n", reference::item::sphere::t));
    EXPECT_FALSE(doubt_of("Question 6:\nt: 3.29988\ndebug: 4.5 5.5\nthere are 2 roots\n", reference::item::sphere::t));
    EXPECT_FALSE(doubt_of("Question 5:\nV: 1.5 2.5 3.5\n", reference::item::sphere::t)) << "nothing was printed for it";
}

TEST(Doubt, SaysWhereTheRightValueStands) {
    const auto doubt = doubt_of("Question 6:\nt: 3.29988\nfar: 2.29988\n", reference::item::sphere::t);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::right_elsewhere);
    EXPECT_EQ(doubt->line, 3);
    const auto in_pieces = doubt_of("Question 6:\nhit: (1.5, 2.5, 3.5)\n3.62297 then\n0.37245 then\n0.73491\n",
                                    reference::item::sphere::hit);
    ASSERT_TRUE(in_pieces);
    EXPECT_EQ(in_pieces->line, 3);
}

TEST(Doubt, IsRaisedByARightNumberOfFewDigitsOnTheAnswersLine) {
    const student::Marking handout = student::handout_scene();
    const auto doubt_of_b = [&](const std::string& lines) {
        const Score marked = score(read_transcript("Question 6:\n" + lines, 10), handout.key, handout.assignment);
        return item_of(marked, reference::item::sphere::b).doubt;
    };
    const auto doubt = doubt_of_b("b: 2, of which the factor: -4\n");
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::right_elsewhere);
    EXPECT_FALSE(doubt_of_b("b: 2\na: -4\n")) << "-4 stands elsewhere";
    EXPECT_FALSE(doubt_of_b("b: 2, c: -4\n")) << "-4 has a name";
}

TEST(Doubt, SeesTheColumnsOfABlock) {
    // The axes are the columns, read as the rows.
    const auto doubt =
        doubt_of("Question 2:\n0.927345 0.045822 0.371391\n-0.151241 0.953698 0.259973\n-0.342282 -0.297255 0.891338\n",
                 reference::item::Y_vcs);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::right_elsewhere);
}

TEST(Doubt, TakesNoAnswersOfOneNumberForAColumn) {
    // rhs is (0, 2, 0). The first numbers of the last three lines are those, by chance.
    const student::Marking marking = student::scene_named("handout");
    const std::string output =
        "Question 4\nS: (0, 0, 2)\nQuestion 5\nV: (0, 0, -1)\nQuestion 8\nA =\n-0.0 2.000 -2.000\n-0.0 4.000 4.000\n"
        "1.000 0.000 0.000\nrhs = (0.000, 2.000, 2.000)\nt = 2.000 u = 0.250 v = 0.250\nP_t = (0.000, 0.000, 2.000)\n";
    const Score score = harness::score(read_transcript(output, 10), marking.key, marking.assignment);
    ASSERT_EQ(verdict_on(score, reference::item::triangle::t), "follow");
    ASSERT_EQ(verdict_on(score, reference::item::triangle::rhs), "wrong");
    EXPECT_FALSE(item_of(score, reference::item::triangle::rhs).doubt);
}

TEST(Doubt, IsNotRaisedByAValueThatWasReadForTheItemAndJudged) {
    // Transposed: right if it were printed by rows, but to_string prints columns.
    const reference::KeyItem& asked = *reference::asked_item(off_axis().key, reference::item::M_VCS_to_WCS);
    const auto& columns = std::get<std::vector<double>>(asked.answers.front().value);
    std::string rows;
    for (std::size_t row = 0; row < 4; ++row) {
        std::string numbers;
        for (std::size_t column = 0; column < 4; ++column)
            numbers += fmt::format("{}{:.6f}", column == 0 ? "" : ", ", columns[4 * column + row]);
        rows += fmt::format("{}({})", row == 0 ? "" : ", ", numbers);
    }
    const std::string output = "Question 3:\nM: mat4x4(" + rows + ")\n";
    ASSERT_EQ(item_of(marked(output), reference::item::M_VCS_to_WCS).verdict, ItemVerdict::wrong);
    EXPECT_FALSE(doubt_of(output, reference::item::M_VCS_to_WCS));
    EXPECT_TRUE(item_of(marked(output), reference::item::M_VCS_to_WCS).by_columns) << "so that the key's is shown so";
}

TEST(Doubt, IsNotRaisedWhereLabelsSayWhichIsWhich) {
    const student::Program right(off_axis().assignment, {});
    const auto u = fmt::format("{:f}", right.scalar(reference::item::triangle::u)),
               v = fmt::format("{:f}", right.scalar(reference::item::triangle::v));
    ASSERT_NE(u, v);
    const std::string swapped = fmt::format("Question 8:\nu = {}\nv = {}\n", v, u);
    for (const reference::ItemId& id : {reference::item::triangle::u, reference::item::triangle::v}) {
        ASSERT_EQ(verdict_on(marked(swapped), id), "wrong");
        EXPECT_FALSE(doubt_of(swapped, id));
    }
    const std::string in_a_row = fmt::format("Question 8:\nu = {}\nthen {}\n", v, u);
    EXPECT_TRUE(doubt_of(in_a_row, reference::item::triangle::u)) << "no label says that the second is v";
    const std::string twice = fmt::format("Question 8:\nv = {}\nv = {}\n", u, v);
    EXPECT_TRUE(doubt_of(twice, reference::item::triangle::u)) << "nothing is said to be u";
}

TEST(Doubt, IsNotRaisedByPiecesOfSeveralValues) {
    // Every third number from the first on, of values that are three, one and three numbers long.
    EXPECT_FALSE(doubt_of("Question 6:\nhit: (3.62297, 2.5, 3.5)\na: 0.37245\nb: 1.25\nc: 6.5\nd: 0.73491\n",
                          reference::item::sphere::hit));
    // The end of a line and the beginning of the next one.
    EXPECT_FALSE(
        doubt_of("Question 6:\nhit: (1.5, 3.62297, 0.37245)\nt: 0.73491\nd: 3.25\n", reference::item::sphere::hit));
}

TEST(Doubt, SaysWhichNumbersWereLeft) {
    const auto doubt = doubt_of("Question 7:\nthis 0.1 that 0.2 other 0.3\n", reference::item::sphere::normal);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::numbers_left);
    EXPECT_EQ(doubt->line, 2);
}

TEST(Doubt, IsRaisedForWholeNumbersOfAnEquationThatWasNotRead) {
    EXPECT_TRUE(doubt_of("Question 6:\nabc = 1 * -4 * 2\nt: 3.29988\n", reference::item::sphere::a));
    EXPECT_FALSE(doubt_of("Question 6:\nthere are 2 roots and 3 numbers\nt: 3.29988\n", reference::item::sphere::a));
}

TEST(Doubt, IsRaisedForWholeNumbersThatStandInNoSentence) {
    const student::Marking handout = student::handout_scene();
    const Score marked = score(read_transcript("Question 8:\n<-0 x 2 x -2>\n<-0 x 4 x 4>\n<1 x 0 x 0>\n", 10),
                               handout.key, handout.assignment);
    const auto doubt = item_of(marked, reference::item::triangle::matrix).doubt;
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->line, 2);
}

TEST(Doubt, IsNotRaisedByLeftNumbersWhereAFollowingAnswerHasItsPoints) {
    // V points the other way, and b and c follow from it.
    student::Marking marking = student::off_axis_scene();
    std::string output = print(
        student::Program(marking.assignment, {},
                         student::Program::Mistake{reference::item::V, [](const student::Program&, const auto& right) {
                                                       auto value = right;
                                                       for (float& x : *value) x = -x;
                                                       return value;
                                                   }}));
    output.insert(output.find("Question 7"), "roots 11.5 12.5\n\n");
    const auto marked_with = [&](double follow_through) {
        marking.assignment.rubric.follow_through = follow_through;
        const Score score = harness::score(read_transcript(output, 10), marking.key, marking.assignment);
        EXPECT_EQ(verdict_on(score, reference::item::sphere::b), "follow");
        return item_of(score, reference::item::sphere::b).doubt;
    };
    EXPECT_FALSE(marked_with(1));
    const auto doubt = marked_with(0.5);
    ASSERT_TRUE(doubt) << "it lost points";
    EXPECT_EQ(doubt->why, Doubt::Why::numbers_left);
}

TEST(Doubt, IsRaisedForWordsInPlaceOfAVerdict) {
    const auto doubt = doubt_of("Question 10:\neloszor gomb\n", reference::item::first_object);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::words_left);
    EXPECT_FALSE(doubt_of("Question 9:\nN: 1 2 3\n", reference::item::first_object)) << "nothing was printed for it";
    EXPECT_TRUE(
        doubt_of("Question 10:\nt = 5.5 for the sphere and for the triangle 2.5\n", reference::item::first_object));
}

TEST(Doubt, IsRaisedForWordsWhereAHitPointWouldStandThoughItsPlaneHasOne) {
    // The ray meets the triangle's plane in any case.
    const auto doubt = doubt_of("Question 8:\nt: 1.5\nu: 0.25\nv: 0.5\nbrak punktu\n", reference::item::triangle::hit);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::words_left);
    EXPECT_EQ(doubt->line, 5);
}

TEST(Doubt, IsRaisedForWordsAboveAValueThatOnlyItsPlaceTold) {
    const std::string output = "Question 6:\nd: -1.25\nbrak punktu\nkolor: (1.5, 2.5, 3.5)\n";
    ASSERT_EQ(item_of(marked(output), reference::item::sphere::hit).verdict, ItemVerdict::wrong);
    const auto doubt = doubt_of(output, reference::item::sphere::hit);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->line, 3);
}

TEST(Doubt, PointsToTheWordsThatStandWhereTheAnswerWould) {
    const auto doubt = doubt_of(
        "Question 5:\nV: (1.5, 2.5, 3.5)\nteraz liczymy\nQuestion 6:\ngomb\na: 1.25\nd: -1.25\n"
        "brak punktu\nQuestion 8:\nt: 1.5\n",
        reference::item::sphere::hit);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->line, 8);
    const auto without_heading = doubt_of("Zadanie pierwsze\nV: (1.5, 2.5, 3.5)\nN: (0.5, 0.5, 0.5)\neloszor gomb\n",
                                          reference::item::first_object);
    ASSERT_TRUE(without_heading);
    EXPECT_EQ(without_heading->line, 4);
}

TEST(Doubt, IsNotRaisedByAQuestionThatIsSaidNotToBeAnswered) {
    for (const char* words : {"not done", "TODO", "not implemented yet", "(skipped)"})
        EXPECT_FALSE(doubt_of("Question 10:\n" + std::string(words) + "\n", reference::item::first_object)) << words;
}

TEST(Doubt, IsRaisedByAnotherAnswerBesideARightOne) {
    const auto line_of = [](const std::string& lines) {
        const auto doubt = doubt_of("Question 6:\n" + lines + "\n", reference::item::sphere::t);
        return doubt && doubt->why == Doubt::Why::another_answer ? doubt->line : 0;
    };
    for (const char* line : {"t: 2.29988 or 3.41", "t = +-2.29988", "t: 2.29988 (wrong, should be 3.41)",
                             "t: 2.29988 is wrong", "t: 2.29988 ... no, 3.41"})
        EXPECT_EQ(line_of(line), 2) << line;
    EXPECT_EQ(line_of("t: 2.29988\nor 3.41"), 3);
    for (const char* line : {"t: 2.29988", "t = 2.29988 or 3.41, so we take 2.29988", "t: 2.29988 (normal or not)",
                             "t: 2.29988, no other root", "t: 2.29988, |V| = 1 (should be 1)"})
        EXPECT_EQ(line_of(line), 0) << line;
}

TEST(Doubt, IsRaisedByTwoNumbersForOne) {
    const auto line_of = [](const std::string& line, reference::ItemId item) {
        const auto doubt = doubt_of("Question 6:\n" + line + "\n", item);
        return doubt && doubt->why == Doubt::Why::another_answer ? doubt->line : 0;
    };
    EXPECT_EQ(line_of("b: -4 and 4", reference::item::sphere::b), 2);
    EXPECT_EQ(line_of("b and c: -4 and 4", reference::item::sphere::b), 0);
    EXPECT_EQ(line_of("b: -4 and c: 4", reference::item::sphere::b), 0);
    EXPECT_EQ(line_of("t: 0.5 and 3.5", reference::item::sphere::t), 0);
}

TEST(Doubt, IsRaisedByVerdictsThatNameEachObject) {
    const auto is_in_doubt = [](const std::string& lines) {
        const auto marked_item = item_of(marked("Question 10:\n" + lines), reference::item::first_object);
        return marked_item.doubt && marked_item.verdict == ItemVerdict::missing;
    };
    for (const char* lines : {"ray hits triangle first\nray hits sphere first\n", "The triangle\nthe sphere\n",
                              "probably ray hits sphere first\n", "ray hits sphere first (or the triangle)\n",
                              "TODO: ray hits sphere first\n"})
        EXPECT_TRUE(is_in_doubt(lines)) << lines;
    for (const char* lines :
         {"ray hits sphere first\n", "ray hits sphere first\nthe sphere is first\n",
          "--- The triangle ---\nray hits sphere first\n", "top cap: none\nray hits sphere first\n",
          "ray does not hit the sphere or the triangle\n", "The triangle is hidden by the sphere\n"})
        EXPECT_FALSE(is_in_doubt(lines)) << lines;
}

TEST(Doubt, IsRaisedIfAnotherPrintingWasPassedOver) {
    const auto doubt =
        doubt_of("Question 6:\nt: 1.75\nQuestion 7:\nN: 0 0 1\nQuestion 6:\nt: 1.85\n", reference::item::sphere::t);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::printed_again);
    EXPECT_EQ(doubt->line, 6);
}

TEST(Doubt, TakesNoLineWithoutAValueForTheEndOfAPrinting) {
    const auto doubt = doubt_of("Q6: a: 1\nQ6: P_s (outside)\nQ6: b: 4\nQ6: c: 7\n", reference::item::sphere::hit);
    EXPECT_FALSE(doubt && doubt->why == Doubt::Why::printed_again);
}

TEST(Doubt, DoesNotTakeThePartsOfAQuestionForPrintingsOfIt) {
    EXPECT_FALSE(
        doubt_of("Question 8 a)\nA: 1 2 3 4 5 6 7 8 9\nQuestion 8 b)\nu: 0.125\n", reference::item::triangle::t));
    EXPECT_TRUE(
        doubt_of("Question 8\nu: 0.125\nQuestion 9\nN: 1 2 3\nQuestion 8\nu: 0.125\n", reference::item::triangle::t));
}

TEST(Doubt, IsRaisedIfLittleWasRead) {
    std::string output = "Question 1:\n";
    for (int i = 0; i < 30; ++i) output += "zzz " + std::to_string(i) + ".25 zzz " + std::to_string(i) + ".75\n";
    const Score score = marked(output);
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items)
            EXPECT_TRUE(item.verdict == ItemVerdict::right || item.doubt) << question.number << item.spec.name;
    }
}

/// The same output with the matrices' types left out: their columns then read as rows.
std::string without_types(std::string output) {
    for (const std::string type : {"mat4x4", "mat3x3"}) {
        for (std::size_t at = output.find(type); at != std::string::npos; at = output.find(type))
            output.erase(at, type.size());
    }
    return output;
}

TEST(Doubt, IsRaisedIfAMatrixSuitsTheOtherAnswersByColumns) {
    const std::string output = without_types(print(student::Program(off_axis().assignment, {})));
    for (const reference::ItemId& id : {reference::item::M_VCS_to_WCS, reference::item::triangle::matrix}) {
        EXPECT_EQ(verdict_on(marked(output), id), "wrong") << id.name;
        const auto doubt = doubt_of(output, id);
        ASSERT_TRUE(doubt) << id.name;
        EXPECT_EQ(doubt->why, Doubt::Why::by_columns) << id.name;
    }
}

TEST(Doubt, IsRaisedIfRowsWereWrittenAsVectors) {
    const auto& key = reference::asked_item(off_axis().key, reference::item::M_VCS_to_WCS)->answers.front().value;
    const auto& columns = std::get<std::vector<double>>(key);
    std::string rows;
    for (std::size_t row = 0; row < 4; ++row) {
        rows += fmt::format("vec4({:.6f}, {:.6f}, {:.6f}, {:.6f})\n", columns[row], columns[4 + row], columns[8 + row],
                            columns[12 + row]);
    }
    const auto doubt = doubt_of("Question 3:\n" + rows, reference::item::M_VCS_to_WCS);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::by_columns);
    EXPECT_THAT(doubts_text(marked("Question 3:\n" + rows), Audience::instructor),
                testing::HasSubstr("the rows of the matrix on line 2 may be its columns"));
}

TEST(Doubt, IsRaisedIfAnAnswerFollowsFromAMatrixInItsOtherOrder) {
    const auto& key = reference::asked_item(off_axis().key, reference::item::triangle::matrix)->answers.front().value;
    const auto& columns = std::get<std::vector<double>>(key);
    std::string output = "Question 8:\nA:";
    for (const double number : columns) output += fmt::format(" {:.6f}", number);
    output += "\nrhs: 1.311999 5.184879 6.863925\n";
    const glm::dmat3 transposed = glm::transpose(glm::dmat3(columns[0], columns[1], columns[2], columns[3], columns[4],
                                                            columns[5], columns[6], columns[7], columns[8]));
    const glm::dvec3 tuv = glm::inverse(transposed) * glm::dvec3(1.311999, 5.184879, 6.863925);
    output += fmt::format("t: {:.6f}\nu: {:.6f}\nv: {:.6f}\n", tuv.x, tuv.y, tuv.z);
    EXPECT_EQ(verdict_on(marked(output), reference::item::triangle::matrix), "right") << "its lines tell no order";
    for (const reference::ItemId& id :
         {reference::item::triangle::t, reference::item::triangle::u, reference::item::triangle::v}) {
        const auto doubt = doubt_of(output, id);
        ASSERT_TRUE(doubt) << id.name;
        EXPECT_EQ(doubt->why, Doubt::Why::by_columns) << id.name;
        EXPECT_EQ(doubt->line, 2);
    }
}

TEST(Doubt, IsRaisedIfOnlyOrderTellsWhichOfSeveralNumbersAWrongOneIs) {
    for (const std::string words : {"", "val9 (is) "}) {
        const std::string numbers = "1\n" + words + "-7.5\n" + words + "10.17111\n" + words + "4.50531\n";
        const auto doubt = doubt_of("Question 6:\n" + words + numbers, reference::item::sphere::b);
        ASSERT_TRUE(doubt) << words;
        EXPECT_EQ(doubt->why, Doubt::Why::by_order);
        EXPECT_EQ(doubt->line, 3);
    }
    EXPECT_FALSE(doubt_of("Question 5:\n1.5 2.5 3.5\n", reference::item::V)) << "the question asks for one vector";
    EXPECT_FALSE(doubt_of("Question 6:\na: 1\nb: -7.5\nc: 10.17111\nd: 4.50531\n", reference::item::sphere::b));
}

TEST(Doubt, IsRaisedByASignThatMayBeANumbersOwn) {
    const auto doubt = doubt_of("Question 6:\nb: -'6.72233'\n", reference::item::sphere::b);
    ASSERT_TRUE(doubt);
    EXPECT_EQ(doubt->why, Doubt::Why::numbers_left);
    EXPECT_EQ(doubt->line, 2);
    EXPECT_FALSE(doubt_of("Question 6:\nb: '6.72233'\n", reference::item::sphere::b));
}

TEST(Doubt, IsNotRaisedIfTheAnswersFollowFromATransposedMatrix) {
    for (const reference::ItemId& id : {reference::item::M_VCS_to_WCS, reference::item::triangle::matrix}) {
        const student::Program::Mistake transposed{id, [](const auto&, const auto& right) {
                                                       student::Floats result = *right;
                                                       const std::size_t n = result.size() == 16 ? 4 : 3;
                                                       for (std::size_t i = 0; i < n * n; ++i)
                                                           result[i] = (*right)[i % n * n + i / n];
                                                       return std::optional(result);
                                                   }};
        // By rows, the transposed matrix is printed as the right one is by columns.
        std::string output = print(student::Program(off_axis().assignment, {}, transposed));
        const std::string type = id == reference::item::M_VCS_to_WCS ? "mat4x4" : "mat3x3";
        const std::string right = print(student::Program(off_axis().assignment, {}));
        const auto line = [&](const std::string& text) {
            const std::size_t begin = text.find(type);
            return std::pair(begin, text.find('\n', begin) - begin);
        };
        const auto [begin, size] = line(right);
        output.replace(line(output).first, line(output).second, right.substr(begin, size).substr(type.size()));
        EXPECT_EQ(verdict_on(marked(output), id), "wrong") << id.name;
        EXPECT_FALSE(doubt_of(output, id)) << id.name;
    }
}

}  // namespace
}  // namespace harness
