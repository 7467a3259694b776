#include "harness/read/words/hit_words.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

std::vector<Meaning> meanings(std::string_view line) {
    std::vector<Meaning> all;
    for (const HitWord& word : hit_words(line)) all.push_back(word.meaning);
    return all;
}

using enum Meaning;

TEST(HitWords, AreReadInAnyCase) {
    EXPECT_EQ(meanings("SPHERE Triangle nearest"), (std::vector{sphere, triangle, nearest}));
    EXPECT_EQ(meanings("closed mist hut mixed formal"), (std::vector(5, other)));
}

TEST(HitWords, AreTheWordsOfANameInCode) {
    EXPECT_EQ(meanings("sphereHit no_hit t_triangle"), (std::vector{sphere, hit, negation, hit, answer, triangle}));
}

TEST(HitWords, KnowContractedNegations) {
    EXPECT_EQ(meanings("doesn't isn't N"), (std::vector{negation, negation, other}));
    EXPECT_EQ(meanings("n/a N/A"), (std::vector{none, none}));
}

TEST(HitWords, KeepTheSignsBetweenThem) {
    const auto words = hit_words("t < -2.5, sphere");
    ASSERT_EQ(words.size(), 3U);
    EXPECT_EQ(words[1].meaning, number);
    EXPECT_EQ(words[1].signs, "<");
    EXPECT_EQ(words[2].signs, ",");
}

}  // namespace
}  // namespace harness
