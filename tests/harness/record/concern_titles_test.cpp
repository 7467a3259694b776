// Every kind of concern has words of its own.
#include "harness/record/concern_titles.h"

#include <gtest/gtest.h>

#include <set>

namespace harness {
namespace {

/// As the manual lists them in review-and-marks.md, with that for a submission that was not graded.
const std::set<std::string> known_kinds{"reading_doubtful",   "mostly_following", "hard_coded",
                                        "other_scene",        "scene_of_another", "nondeterministic",
                                        "variants_not_tried", "not_graded",       "late_without_date"};

TEST(ConcernTitles, AreSentencesAndNotNamesOfKinds) {
    std::set<std::string> sentences;
    for (const std::string& kind : known_kinds) {
        const ConcernTitle title = title_of(kind);
        for (const std::string& text : {title.sentence, title.in_a_line, title.of_many}) {
            EXPECT_FALSE(text.empty()) << kind;
            EXPECT_EQ(text.find('_'), std::string::npos) << kind;
        }
        std::string words = kind;
        for (char& c : words)
            if (c == '_') c = ' ';
        EXPECT_NE(title.sentence, words);
        sentences.insert(title.sentence);
    }
    EXPECT_EQ(sentences.size(), known_kinds.size());
}

TEST(ConcernTitles, UseTheWordsOfAnUnknownKind) {
    EXPECT_EQ(title_of("of_a_newer_raygrade").sentence, "of a newer raygrade");
}

TEST(ConcernTitles, PutUnknownKindsBeforeNotGraded) {
    EXPECT_EQ(urgency_of("reading_doubtful"), 0U);
    EXPECT_LT(urgency_of("variants_not_tried"), urgency_of("of_a_newer_raygrade"));
    EXPECT_LT(urgency_of("of_a_newer_raygrade"), urgency_of("not_graded"));
    EXPECT_LT(urgency_of("not_graded"), urgency_of("late_without_date"));
}

}  // namespace
}  // namespace harness
