#include "harness/read/words/hit_words.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "harness/read/words/hit_words_table.h"

namespace harness {
namespace {

std::vector<Meaning> meanings(std::string_view line) {
    std::vector<Meaning> all;
    for (const HitWord& word : hit_words(line)) all.push_back(word.meaning);
    return all;
}

using enum Meaning;

TEST(HitWords, HaveOneMeaningInAllLanguages) {
    std::map<std::string, Meaning> meanings;
    for (const MeaningRow& row : hit_words_table()) {
        for (const std::string_view words :
             {row.english, row.german, row.french, row.spanish, row.italian, row.portuguese, row.others}) {
            std::istringstream each{std::string(words)};
            for (std::string word; each >> word;) {
                EXPECT_EQ(meanings.try_emplace(word, row.meaning).first->second, row.meaning) << word;
            }
        }
    }
}

TEST(HitWords, AreReadWithoutAccentsAndInAnyCase) {
    EXPECT_EQ(meanings("SPH\u00c8RE Tri\u00e1ngulo n\u00e4chste"), (std::vector{sphere, triangle, nearest}));
}

TEST(HitWords, MayHaveALetterWrongIfTheyAreLong) {
    EXPECT_EQ(meanings("cylnder traingle intersecton spheree sph\xEF\xBF\xBDre"),
              (std::vector{cylinder, triangle, hit, sphere, sphere}));
    EXPECT_EQ(meanings("closed mist hut mixed formal"), (std::vector(5, other)));
}

TEST(HitWords, AreTheWordsOfANameInCode) {
    EXPECT_EQ(meanings("sphereHit no_hit t_triangle"), (std::vector{sphere, hit, negation, hit, answer, triangle}));
}

TEST(HitWords, KnowElidedAndContractedNegations) {
    EXPECT_EQ(meanings("n'intersecte doesn't N"), (std::vector{negation, hit, negation, link}));
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
