#include "harness/match/candidates.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace harness {
namespace {

std::vector<reference::ItemSpec> items_of(int question) {
    std::vector<reference::ItemSpec> items;
    const auto all = reference::default_items();
    std::copy_if(all.begin(), all.end(), std::back_inserter(items),
                 [&](const auto& item) { return item.question == question; });
    return items;
}

std::vector<Candidate> arranged(int question, std::string_view text) {
    const Transcript transcript =
        read_transcript("Question " + std::to_string(question) + ":\n" + std::string(text), 10);
    return candidates_of(transcript.sections.back().values, items_of(question));
}

std::vector<double> values(const Candidate& candidate) {
    std::vector<double> numbers;
    for (const PrintedNumber& number : candidate.value.numbers) numbers.push_back(number.value);
    return numbers;
}

TEST(FindCandidates, LeavesSeparatelyNamedVectorsOutOfAMatrix) {
    const auto candidates = arranged(8, "rhs = (1, 2, 3)\nhit = (4, 5, 6)\nP = (7, 8, 9)\n");
    ASSERT_EQ(candidates.size(), 3U);
    EXPECT_EQ(values(candidates[0]), (std::vector<double>{1, 2, 3}));
}

TEST(FindCandidates, GathersRowsAndDividesAnAugmentedMatrix) {
    const auto candidates = arranged(8, "[A|b]\n1 2 3 | 4\n5 6 7 | 8\n9 10 11 | 12\n");
    ASSERT_EQ(candidates.size(), 2U);
    EXPECT_EQ(candidates[0].order, MatrixOrder::rows);
    EXPECT_EQ(values(candidates[0]), (std::vector<double>{1, 2, 3, 5, 6, 7, 9, 10, 11}));
    EXPECT_EQ(values(candidates[1]), (std::vector<double>{4, 8, 12}));
    EXPECT_EQ(candidates[1].first, 0U);
    EXPECT_EQ(candidates[1].count, 3U);
}

TEST(FindCandidates, TakesTypedRowsAsColumns) {
    const auto candidates = arranged(8, "A[0] = vec3(1, 2, 3)\nA[1] = vec3(4, 5, 6)\nA[2] = vec3(7, 8, 9)\n");
    ASSERT_EQ(candidates.size(), 1U);
    EXPECT_EQ(candidates[0].order, MatrixOrder::columns);
}

TEST(FindCandidates, GathersRowsThatRepeatTheirMatrixsLabel) {
    const auto candidates = arranged(8, "A | 1 2 3\nA | 4 5 6\nA | 7 8 9\nrhs | 1 2 3\n");
    ASSERT_EQ(candidates.size(), 2U);
    EXPECT_EQ(candidates[0].order, MatrixOrder::rows);
    EXPECT_EQ(candidates[0].value.label, "A");
    EXPECT_EQ(values(candidates[0]), (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(arranged(8, "A | 1 2 3\nB | 4 5 6\nC | 7 8 9\n").size(), 3U);
    EXPECT_EQ(arranged(8, "P_t | 1 2 3\nP_t | 4 5 6\nP_t | 7 8 9\n").size(), 3U);
}

TEST(FindCandidates, LeavesTheOrderOfAFlatListOpen) {
    const auto candidates = arranged(8, "A = 1 2 3 4 5 6 7 8 9\n");
    ASSERT_EQ(candidates.size(), 1U);
    EXPECT_EQ(candidates[0].order, MatrixOrder::unsaid);
}

TEST(FindCandidates, JoinsFramedNumbersOnConsecutiveLines) {
    const auto candidates = arranged(8, "      | 1 |\nP_t = | 2 |\n      | 3 |\n");
    ASSERT_EQ(candidates.size(), 1U);
    EXPECT_EQ(values(candidates[0]), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(candidates[0].value.label, "P_t");
}

TEST(FindCandidates, KeepsScalarsOnConsecutiveLinesApart) {
    EXPECT_EQ(arranged(6, "1\n-4\n2\n").size(), 3U);
    EXPECT_EQ(arranged(5, "1\n-4\n2\n").size(), 1U);  // no scalar is asked for
    EXPECT_EQ(arranged(9, "step 0.5\n1\n-4\n2\n").size(), 2U);
    EXPECT_EQ(arranged(9, "N: 0.5\n1\n-4\n1\n").size(), 1U);
}

TEST(FindCandidates, SplitsAListWithNames) {
    const auto candidates = arranged(8, "(u, v, t) = (1, 2, 3)\n");
    ASSERT_EQ(candidates.size(), 3U);
    EXPECT_EQ(candidates[2].value.label, "t");
    EXPECT_EQ(values(candidates[2]), std::vector<double>{3});
}

}  // namespace
}  // namespace harness
