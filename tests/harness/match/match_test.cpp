#include "harness/match/match.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/given/parsed.h"

namespace harness {
namespace {

TEST(Match, ReadsAMatrixBesideVectorsWhoseNamesItsLabelHolds) {
    const std::vector<reference::ItemSpec> items =
        reference::asked_items({{1, "", {reference::item::P_VCS, reference::item::M_VCS_to_WCS, reference::item::V}}});
    const auto matched = match(read_transcript("Question 1\nP_VCS | 1 2 3\nM_VCS_to_WCS | 1 0 0 5\n | 0 1 0 6\n"
                                               " | 0 0 1 7\n | 0 0 0 1\nV | 0 0 -1\n",
                                               1),
                               items);
    ASSERT_TRUE(matched[1].value);
    EXPECT_FALSE(matched[1].unreadable);
    EXPECT_EQ(matched[1].value->numbers.size(), 16U);
    ASSERT_TRUE(matched[2].value);
    EXPECT_EQ(matched[2].value->numbers[2].value, -1);
}

TEST(Match, TellsWhetherAnItemWasFoundByItsOrder) {
    const auto items = reference::asked_items({{5, "", {reference::item::V}}});
    const auto found_by_order = [&](const std::string& printout) {
        const auto matched = match(read_transcript(printout, 5), items);
        EXPECT_TRUE(matched.front().value);
        return matched.front().by_order;
    };
    EXPECT_TRUE(found_by_order("Question 5:\n0 0 -1\n"));
    EXPECT_TRUE(found_by_order("Question 5:\nanswer: 0 0 -1\n"));
    EXPECT_FALSE(found_by_order("Question 5:\nV = 0 0 -1\n"));
    EXPECT_FALSE(found_by_order("Question 5:\nThe vector V:\n0 0 -1\n"));
}

TEST(Match, TakesWhatALogsWordStandsBeforeOnlyIfNothingElseAnswers) {
    EXPECT_EQ(parsed_values("Question 5:\nV = (1, 2, 3)\ncheck V = (4, 5, 6)\n"), "5.V: 1 2 3 @2\n");
    EXPECT_EQ(parsed_values("Question 5:\n(1, 2, 3)\n[DEBUG] V = (4, 5, 6)\n"), "5.V: 1 2 3 @2\n");
    EXPECT_EQ(parsed_values("Question 6:\nt = none\nSphere test: t = 0.5\n"), "6.t: none @2\n6.hit: none @2\n");
}

TEST(Match, TakesAVectorForWhatItIsAndNotForWhereItIs) {
    EXPECT_EQ(parsed_values("Question 6:\nhit at (1, 2, 3) with normal (0, 0, 1)\n"),
              "6.hit: 1 2 3 @2\n7.normal: 0 0 1 @2\n");
    EXPECT_EQ(parsed_values("Question 7:\nN = (0, 0, 16)\nV / 16.0 = (0, 0, 1)\n"), "7.normal: 0 0 16 @2\n");
}

TEST(Match, TakesANameForWhatItsFormulaSays) {
    EXPECT_EQ(
        parsed_values("Question 6:\na = 1\nb = -4\nc = 2\nDiscriminant (b^2 - 4ac) = 8\nRoots: 0.5 and 3.5\nt = 0.5\n"),
        "6.a: 1 @2\n6.b: -4 @3\n6.c: 2 @4\n6.d: 8 @5\n6.t: 0.5 @7\n");
    EXPECT_EQ(parsed_values("Question 6:\na: 1\nb: -4\nc: 2\nDiscriminant (b^2 - 4ac) is 8\nRoots: 0.5 and 3.5\n"),
              "6.a: 1 @2\n6.b: -4 @3\n6.c: 2 @4\n6.d: 8 @5\n6.t: 0.5 @6\n");
    EXPECT_EQ(parsed_values("Question 6:\nt (-b - sqrt(d))/(2a) = 0.5\nt (far) = 3.5\n"), "6.t: 0.5 @2\n");
    for (const std::string product : {"vup x Z", "cross(vup, Z)"}) {
        EXPECT_EQ(
            parsed_values("Question 2:\nZ = (0, 0, 1)\n" + product + " = (3, 4, 5)\nX = (1, 0, 0)\nY = (0, 1, 0)\n"),
            "2.X_vcs: 1 0 0 @4\n2.Y_vcs: 0 1 0 @5\n2.Z_vcs: 0 0 1 @2\n");
    }
}

TEST(Match, ReadsAnswersInARow) {
    EXPECT_EQ(parsed_values("Question 6:\na is 1 b is -4.5 c is 2\n"), "6.a: 1 @2\n6.b: -4.5 @2\n6.c: 2 @2\n");
}

TEST(Match, ReadsTheSamePlacesWhateverTheNumbersAre) {
    // No decision may depend on which value is right, so different numbers in the same layout are read alike.
    const std::string layout =
        "Question 6:\na = 1A b = 1B c = 1C\n1D\nt1 = 1E t2 = 1F\nt = 1G\n(1H, 1I, 1J)\nQuestion 8:\n1K 1L 1M\n1N 1O "
        "1P\n1Q 1R 1S\n(1T, 1U, 1V)\nu = 1W v = 1X t = 1Y\n";
    std::mt19937_64 random(5);
    std::string first;
    for (int trial = 0; trial < 50; ++trial) {
        std::string output;
        for (std::size_t i = 0; i < layout.size(); ++i) {
            const bool digit =
                layout[i] == '1' && i + 1 < layout.size() && layout[i + 1] >= 'A' && layout[i + 1] <= 'Y';
            output +=
                digit ? std::to_string(random() % 9) + "." + std::to_string(random() % 9) : std::string(1, layout[i]);
            if (digit) ++i;
        }
        std::string places;
        for (const MatchedItem& item : match(read_transcript(output, 10), reference::default_items())) {
            places += std::to_string(item.spec.question) + std::string(item.spec.name) +
                      (item.value ? " " + std::to_string(item.value->line) : "") + "\n";
        }
        if (first.empty()) first = places;
        EXPECT_EQ(places, first) << output;
    }
}

TEST(Match, TakesTheLastOfSeveralValuesWithOneLabel) {
    EXPECT_EQ(parsed_values("Question 6:\nt = 3.4\nt = 0.6\n"), "6.t: 0.6 @3\n");
}

TEST(Match, JoinsThePartsOfAQuestion) {
    EXPECT_EQ(parsed_values("Q8> row: 1 2 3\nQ8> row: 4 5 6\nQ8> row: 7 8 9\n"),
              "8.matrix: (1 4 7) (2 5 8) (3 6 9) by rows @1\n");
    EXPECT_EQ(parsed_values("Question 6a:\na = 3.4\nQuestion 6b:\nb = 0.6\n"), "6.a: 3.4 @2\n6.b: 0.6 @4\n");
}

TEST(Match, GivesNoValueToADifferentQuestion) {
    EXPECT_EQ(parsed_values("Question 6:\nt = 3.4\nt = 0.6\n(0, 0, 1)\n"), "6.t: 0.6 @3\n6.hit: 0 0 1 @4\n");
}

TEST(Match, FindsAQuestionWithoutItsHeading) {
    EXPECT_EQ(parsed_values("Question 6:\nt = 0.6\nsphere normal = (0, 0, 1)\n"), "6.t: 0.6 @2\n7.normal: 0 0 1 @3\n");
}

TEST(Match, DividesOutputWithoutHeadingsByOrder) {
    EXPECT_EQ(
        parsed_values("t: 0.6\nP_s: (1, 2, 3)\nN: (0, 1, 0)\nt: 0.9\nu: 0.1\nv: 0.2\nP_t: (4, 5, 6)\nN: (0, 0, 1)\n"),
        "6.t: 0.6 @1\n6.hit: 1 2 3 @2\n7.normal: 0 1 0 @3\n8.t: 0.9 @4\n8.u: 0.1 @5\n8.v: 0.2 @6\n8.hit: 4 5 6 "
        "@7\n9.normal: 0 0 1 @8\n");
}

TEST(Match, NamesValuesThatCannotBeRead) {
    EXPECT_EQ(parsed_values("Question 5:\nV = (1, 2)\n"), "5.V: ? 1 2 @2\n");
}

TEST(Match, TakesThreeNamesThatGoTogetherForTheAxes) {
    const std::string axes = "2.X_vcs: 1 0 0 @2\n2.Y_vcs: 0 1 0 @3\n2.Z_vcs: 0 0 1 @4\n";
    const std::string begin = "Question 2:\n";
    EXPECT_EQ(parsed_values(begin + "right vector = (1, 0, 0)\nup vector = (0, 1, 0)\nbackward vector = (0, 0, 1)\n"),
              axes);
    EXPECT_EQ(
        parsed_values(begin + "Basis vector 1: (1, 0, 0)\nBasis vector 2: (0, 1, 0)\nBasis vector 3: (0, 0, 1)\n"),
        axes);
    EXPECT_EQ(
        parsed_values(begin + "The camera's right vector is (1, 0, 0),\nits up vector is (0, 1, 0),\nand its backward "
                              "vector is (0, 0, 1).\n"),
        axes);
}

TEST(Match, TakesNothingFromALineThatSaysItIsNoAnswer) {
    const std::string answers = "Question 8:\nt = 1.5\nu = 0.25\nv = 0.5\n";
    const std::string none = parsed_values(answers);
    for (const char* line : {"alpha = 0.25, beta = 0.75, gamma = 0", "used 3 multiplications", "(took 0.008 ms)"})
        EXPECT_EQ(parsed_values(answers + line + "\n"), none) << line;
}

TEST(Match, TakesTheRaysOriginForThePixelAndNotForTheDirection) {
    for (const char* name : {"Ray origin", "Ray start", "ray.origin", "Origin of the ray"}) {
        const std::vector<reference::ItemSpec> items =
            reference::asked_items({{1, "", {reference::item::P_WCS, reference::item::V}}});
        const auto matched =
            match(read_transcript(fmt::format("Question 1\n{}: (4, 1, 0)\nV: (-1, 0, 0)\n", name), 1), items);
        ASSERT_TRUE(matched[0].value && matched[1].value) << name;
        EXPECT_EQ(matched[0].value->numbers[0].value, 4) << name;
    }
    EXPECT_EQ(parsed_values("Question 5:\ndirection of the ray from its origin: (1, 2, 3)\n"), "5.V: 1 2 3 @2\n");
}

TEST(Match, ReadsARayWrittenOut) {
    EXPECT_EQ(parsed_values("Question 5:\nUnit vector V: (0, 0, -1)\nR(t) = vec3(0, 0, 2) + t * vec3(0, 0, -2)\n"),
              "5.V: 0 0 -1 @2\n")
        << "a name is surer than a formula";
}

TEST(Match, TakesTheViewMatrixForNoInverse) {
    const std::string view = "((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, -4, 1))",
                      inverse = "((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 4, 1))";
    const std::string expected = "3.M_VCS_to_WCS: (1 0 0 0) (0 1 0 0) (0 0 1 0) (0 0 4 1) by columns @";
    EXPECT_EQ(parsed_values("Question 3:\nView matrix: mat4x4" + view + "\nInverse: mat4x4" + inverse + "\n"),
              expected + "3\n");
    EXPECT_EQ(
        parsed_values("Question 3:\nInverse view matrix: mat4x4" + inverse + "\nView matrix: mat4x4" + view + "\n"),
        expected + "2\n");
}

TEST(Match, ReadsCoordinatesByTheNameOfTheirFrame) {
    for (const char* lines :
         {"x_VCS = 1\ny_VCS = 2\nz_VCS = 3", "xVCS = 1\nyVCS = 2\nzVCS = 3", "x in VCS: 1\ny in VCS: 2\nz in VCS: 3"})
        EXPECT_EQ(parsed_values(std::string("Question 1:\n") + lines + "\n"), "1.P_VCS: 1 2 3 @2\n") << lines;
    EXPECT_EQ(parsed_values("Question 6:\nx_s = 1, y_s = 2, z_s = 3\n"), "6.hit: 1 2 3 @2\n");
}

TEST(Match, ReadsTheNumberBehindALeader) {
    for (const char* lines :
         {"a..............1\nb.............-4", "a______________1\nb_____________-4", "a ........ 1\nb ........ -4"})
        EXPECT_EQ(parsed_values(std::string("Question 6:\n") + lines + "\n"), "6.a: 1 @2\n6.b: -4 @3\n") << lines;
    EXPECT_EQ(parsed_values("Question 6:\na = .5\n"), "6.a: 0.5 @2\n");
}

TEST(Match, ReadsTheUnitVectorBesideTheRawOne) {
    EXPECT_EQ(parsed_values("Question 7:\nraw: (-1, -1, 2)\nunit: (0, 0, 1)\n"), "7.normal: 0 0 1 @3\n");
    EXPECT_EQ(parsed_values("Question 7:\nNormal: (-1, -1, 2) normalized to (0, 0, 1)\n"), "7.normal: 0 0 1 @2\n");
}

TEST(Match, ReadsPartsThatBeginOnTheHeadingsLine) {
    EXPECT_EQ(parsed_values("Question 6: (a) a = 1\n(b) b = -4\n(c) c = 2\n(d) d = 8\n"),
              "6.a: 1 @1\n6.b: -4 @2\n6.c: 2 @3\n6.d: 8 @4\n");
    EXPECT_EQ(parsed_values("6) a) 1\nb) -4\nc) 2\nd) 8\ne) 0.5\n7) (0, 0, 1)\n8) a) t = 1\n9) (0, 1, 0)\n"),
              "6.a: 1 @1\n6.b: -4 @2\n6.c: 2 @3\n6.d: 8 @4\n6.t: 0.5 @5\n7.normal: 0 0 1 @6\n8.t: 1 @7\n9.normal: 0 1 "
              "0 @8\n");
}

TEST(Match, ReadsTheAxesByTheirClassicalNames) {
    for (const char* names : {"uvn", "uvw"})
        EXPECT_EQ(parsed_values(fmt::format("Question 2:\n{}: (1, 0, 0)\n{}: (0, 1, 0)\n{}: (0, 0, 1)\n", names[0],
                                            names[1], names[2])),
                  "2.X_vcs: 1 0 0 @2\n2.Y_vcs: 0 1 0 @3\n2.Z_vcs: 0 0 1 @4\n")
            << names;
}

TEST(Match, TakesARowsIndexInBracketsForItsLabel) {
    for (const char* sign : {" ", ": ", " = "}) {
        const std::string output = fmt::format(
            "Question 3:\n[0]{0}vec4(1, 0, 0, 0)\n[1]{0}vec4(0, 1, 0, 0)\n[2]{0}vec4(0, 0, 1, 0)\n"
            "[3]{0}vec4(6, 1, 0, 1)\n",
            sign);
        EXPECT_EQ(parsed_values(output), "3.M_VCS_to_WCS: (1 0 0 0) (0 1 0 0) (0 0 1 0) (6 1 0 1) by columns @2\n")
            << sign;
    }
}

TEST(Match, ReadsThePartsOfAQuestionInBrackets) {
    EXPECT_EQ(parsed_values(
                  "Question 6(a)\na = 1\nb = -8\nQuestion 6(b)\nt = 0.6\nP_s = (1, 2, 3)\nQuestion 7\nN = (0, 0, 1)\n"),
              "6.a: 1 @2\n6.b: -8 @3\n6.t: 0.6 @5\n6.hit: 1 2 3 @6\n7.normal: 0 0 1 @8\n");
}

TEST(Match, ListsEveryItemInOrderForAnEmptyOutput) {
    const auto matched = match(read_transcript("", 10), reference::default_items());
    ASSERT_EQ(matched.size(), reference::default_items().size());
    EXPECT_EQ(matched.back().spec.question, 10);
    EXPECT_EQ(match(Transcript{}, reference::default_items()).size(), reference::default_items().size());
}

TEST(Match, TakesTheInverseOfAViewMatrixBesideIt) {
    const std::string view = "(1 0 0 0) (0 1 0 0) (0 0 1 0) (0 0 -4 1)",
                      inverse = "(1 0 0 0) (0 1 0 0) (0 0 1 0) (0 0 4 1)";
    const auto printed = [](const std::string& columns) {
        std::string list = columns;
        for (std::size_t at = 0; (at = list.find(' ', at)) != std::string::npos; at += 2) list.replace(at, 1, ", ");
        return "mat4x4(" + list + ")";
    };
    for (const auto& [one, other] :
         std::vector<std::pair<std::string, std::string>>{{"lookAt", "inverse"},
                                                          {"World to camera", "Camera to world"},
                                                          {"WCS -> VCS", "VCS -> WCS"},
                                                          {"M", "inv(M)"},
                                                          {"viewMatrix", "viewMatrixInv"},
                                                          {"W2C", "C2W"},
                                                          {"Matrix", "Inverse matrix"},
                                                          {"View matrix", "Its inverse"}})
        EXPECT_EQ(
            parsed_values(fmt::format("Question 3:\n{}: {}\n{}: {}\n", one, printed(view), other, printed(inverse))),
            fmt::format("3.M_VCS_to_WCS: {} by columns @3\n", inverse))
            << one;
}

TEST(Match, TakesAMatrixBelowInverseOfForNoInverse) {
    EXPECT_EQ(parsed_values("Question 3: inverse of\n1 0 0 0\n0 1 0 0\n0 0 1 -4\n0 0 0 1\nis\n1 0 0 0\n0 1 0 0\n0 0 1 "
                            "4\n0 0 0 1\nQuestion 8:\n"),
              "3.M_VCS_to_WCS: (1 0 0 0) (0 1 0 0) (0 0 1 0) (0 0 4 1) by rows @7\n");
}

TEST(Match, TakesAProductsNameFromItsTitle) {
    EXPECT_EQ(
        parsed_values("Question 3:\nR =\n0 0 1 0\n0 1 0 0\n-1 0 0 0\n0 0 0 1\nM_VCS_to_WCS = T * R:\n0 0 1 6\n0 1 0 1\n"
                      "-1 0 0 0\n0 0 0 1\nQuestion 8:\n"),
        "3.M_VCS_to_WCS: (0 0 -1 0) (0 1 0 0) (1 0 0 0) (6 1 0 1) by rows @8\n");
}

TEST(Match, ReadsColumnsNamedByTheirAxes) {
    EXPECT_EQ(parsed_values("Question 3:\nFirst column (X_vcs): (1, 0, 0, 0)\nSecond column (Y_vcs): (0, 1, 0, 0)\n"
                            "Third column (Z_vcs): (0, 0, 1, 0)\nFourth column (eye): (0, 0, 4, 1)\n"),
              "3.M_VCS_to_WCS: (1 0 0 0) (0 1 0 0) (0 0 1 0) (0 0 4 1) by columns @2\n");
}

TEST(Match, GivesTheSameOfSeveralObjectsToEach) {
    namespace item = reference::item;
    const auto items = reference::asked_items({{1, "", {item::triangle::t, item::sphere::t, item::cylinder::t}}});
    const auto numbers = [&](const std::string& output) {
        std::vector<double> found;
        for (const MatchedItem& each : match(read_transcript("Question 1:\n" + output, 2), items))
            found.push_back(each.value && !each.value->numbers.empty() ? each.value->numbers.front().value : -1);
        return found;
    };
    const std::vector<double> in_order{1.5, 2.5, 3.5};
    EXPECT_EQ(numbers("t: 1.5\nt: 2.5\nt: 3.5\n"), in_order);
    EXPECT_EQ(numbers("Cylinder:\nt: 3.5\nSphere:\nt: 2.5\nTriangle:\nt: 1.5\n"), in_order);
    EXPECT_EQ(numbers("t (cylinder) = 3.5\nt (triangle) = 1.5\nt (sphere) = 2.5\n"), in_order);
    EXPECT_EQ(
        numbers("The ray hits the sphere at t = 2.5\nThe ray hits the triangle at t = 1.5\nThe ray hits the cylinder "
                "at t = 3.5\n"),
        in_order);
}

TEST(Match, ReadsThePartsOfAQuestionAboutSeveralObjects) {
    namespace item = reference::item;
    const auto items = reference::asked_items({{1,
                                                "",
                                                {item::triangle::t, item::triangle::hit, item::sphere::d,
                                                 item::sphere::t, item::sphere::hit, item::cylinder::t}}});
    const auto matched =
        match(read_transcript("Q1a) t 1.5\nPt 1 0 0\nQ1b) d 8\nt 2.5\nPs 0 1 0\nQ1c) t 3.5\nQ2: 1\n", 2), items);
    for (const auto& [i, t] : std::vector<std::pair<std::size_t, double>>{{0, 1.5}, {3, 2.5}, {5, 3.5}}) {
        ASSERT_TRUE(matched[i].value) << i;
        EXPECT_EQ(matched[i].value->numbers.front().value, t);
    }
}

TEST(Match, CountsTheFirstOfTwoAttempts) {
    EXPECT_EQ(parsed_values("Question 6:\na: 1\nb: -4\nt: 9\nQuestion 6:\na: 1\nb: -4\nt: 0.5\n"),
              "6.a: 1 @2\n6.b: -4 @3\n6.t: 9 @4\n");
}

TEST(Match, TakesADashBeforeEachAxisForTheMarkOfAList) {
    EXPECT_EQ(parsed_values("Question 2:\n-X_vcs: (0, 0, -1)\n-Y_vcs: (0, 1, 0)\n-Z_vcs: (1, 0, 0)\n"),
              "2.X_vcs: 0 0 -1 @2\n2.Y_vcs: 0 1 0 @3\n2.Z_vcs: 1 0 0 @4\n")
        << "the marks of a list";
}

}  // namespace
}  // namespace harness
