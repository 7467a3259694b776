#include "harness/grade/written_answers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/harness/source/scene/handouts.h"

namespace harness {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

Score printed(const std::string& text, ItemVerdict verdict = ItemVerdict::right) {
    Score score;
    score.questions.emplace_back();
    score.questions.back().number = 6;
    ItemScore item;
    item.spec = {6, "t", reference::Shape::scalar, "t", reference::item::sphere::t};
    item.printed = text;
    item.verdict = verdict;
    score.questions.back().items = {item};
    return score;
}

TEST(WrittenAnswers, AreFoundInStringsAndLiteralsWithTheirLine) {
    const auto found =
        written_answers("int x;\n\nputs(\"t = 0.585786\");", printed("0.5857860"), source::scene_of_2021());
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_EQ(found[0].line, 3U);
    EXPECT_EQ(found[0].number, "0.5857860");
    EXPECT_THAT(written_answers("puts(\"00.585786\");", printed("0.585786"), source::scene_of_2021()), SizeIs(1));
    EXPECT_THAT(written_answers("puts(\"0.585786 3.41421\");", printed("(0.585786, 3.41421)"), source::scene_of_2021()),
                SizeIs(1))
        << "one answer";
    EXPECT_THAT(written_answers("float t = -3.41421f;", printed("(0, -3.41421)"), source::scene_of_2021()), SizeIs(1));
}

TEST(WrittenAnswers, ExcludeShortAndCommentedAndWrongAnswers) {
    EXPECT_THAT(written_answers("puts(\"0.25 4 1.0000 200 150.000\");", printed("0.25 4 1.0000 200 150.000"),
                                source::scene_of_2021()),
                IsEmpty());
    EXPECT_THAT(written_answers("puts(\"12345\");", printed("12345"), source::scene_of_2021()), IsEmpty());
    EXPECT_THAT(written_answers("// 0.585786\n", printed("0.585786"), source::scene_of_2021()), IsEmpty());
    EXPECT_THAT(
        written_answers("puts(\"0.585786\");", printed("0.585786", ItemVerdict::wrong), source::scene_of_2021()),
        IsEmpty());
}

TEST(WrittenAnswers, ExcludeNumbersOfTheScene) {
    source::DecimalScene other = source::scene_of_2021();
    other.camera.eye.x = reference::Decimal::parse("-3.1250").value();
    EXPECT_THAT(written_answers("vec3 eye(-3.125, 0, 4);", printed("3.125000"), other), IsEmpty());
}

TEST(PrintedConstants, AreFoundInStringsAndAfterTheStreamOperatorEvenIfWrong) {
    const auto wrong = [](const std::string& text) { return printed(text, ItemVerdict::wrong); };
    EXPECT_THAT(printed_constants("puts(\"t = 0.712345\");", wrong("0.712345"), source::scene_of_2021()), SizeIs(1));
    EXPECT_THAT(printed_constants("cout << \"t = \" << -0.71234f;", wrong("-0.71234"), source::scene_of_2021()),
                SizeIs(1));
    EXPECT_THAT(printed_constants("assert(abs(t - 0.585786) < 1e-4);", printed("0.585786"), source::scene_of_2021()),
                IsEmpty())
        << "a program may check what it computes";
    EXPECT_THAT(printed_constants("cout << t;", wrong("0.712345"), source::scene_of_2021()), IsEmpty());
}

}  // namespace
}  // namespace harness
