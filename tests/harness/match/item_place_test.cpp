#include "harness/match/item_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/match/match.h"

namespace harness {
namespace {

using testing::ElementsAre;

const reference::ItemSpec& spec_of(int question, std::string_view name) {
    for (const reference::ItemSpec& item : reference::default_items()) {
        if (item.question == question && item.name == name) return item;
    }
    throw std::logic_error("no such item");
}

ItemPlace place(int question, std::string_view item, std::string_view lines) {
    ItemPlace result = lines.empty() ? ItemPlace{} : read_lines(lines).value();
    result.question = question;
    result.item = item;
    result.note = "somebody says so";
    return result;
}

std::vector<double> numbers(const std::optional<MatchedItem>& item) {
    std::vector<double> values;
    if (!item || !item->value) return values;
    for (const PrintedNumber& number : item->value->numbers) values.push_back(number.value);
    return values;
}

/// What is read for an item from the lines of an output.
std::vector<double> read(int question, std::string_view item, std::string_view lines, std::string_view output) {
    Transcript transcript = read_transcript(output, 10);
    return numbers(
        read_at(transcript, spec_of(question, item), place(question, item, lines), reference::default_items()));
}

/// All items matched, with places.
std::vector<double> matched(int question, std::string_view item, std::string_view output,
                            const std::vector<ItemPlace>& places) {
    for (const MatchedItem& each : match(read_transcript(output, 10), reference::default_items(), places)) {
        if (each.spec.question == question && each.spec.name == item) return numbers(each);
    }
    return {};
}

TEST(ItemPlace, IsReadFromLinesAndNumbers) {
    EXPECT_EQ(read_lines("12")->last_line, 12);
    EXPECT_EQ(read_lines("12-14")->last_line, 14);
    EXPECT_THAT(read_lines("12:2-4,14:1")->numbers,
                ElementsAre(NumberPlace{12, 2}, NumberPlace{12, 3}, NumberPlace{12, 4}, NumberPlace{14, 1}));
    EXPECT_EQ(read_lines("12:2,14:1")->last_line, 14);
    for (const char* lines : {"12", "12-14", "12:2", "12:2-4", "12:2-4,14:1", "14:1,12:2", "12:1,12:-2,12:-3"})
        EXPECT_EQ(lines_text(*read_lines(lines)), lines);
    for (const char* wrong : {"", "0", "x", "14-12", "12-", "-12", "12:", "12:0", "12-14:2", "12:1,", "12:1,13",
                              "12:-1-2", "1e3", "99999999999"})
        EXPECT_FALSE(read_lines(wrong)) << wrong;
}

TEST(ItemPlace, HoldsTheValueOfTheItemsShape) {
    const std::string output = "Question 6\nfoo: 2.5\nbar: (1, 2, 3) and 4.5\n";
    EXPECT_THAT(read(6, "t", "2", output), ElementsAre(2.5));
    EXPECT_THAT(read(6, "hit", "3", output), ElementsAre(1, 2, 3));
    EXPECT_THAT(read(6, "t", "3:4", output), ElementsAre(4.5));
    EXPECT_THAT(read(6, "hit", "3:2-4", output), ElementsAre(2, 3, 4.5));
    EXPECT_THAT(read(6, "hit", "2:1,3:-4,3:1", output), ElementsAre(2.5, -4.5, 1));
}

TEST(ItemPlace, HoldsNumbersThatAreGluedToLetters) {
    EXPECT_THAT(read(6, "hit", "2", "Question 6\nx1.5y2.5z3.0m\n"), ElementsAre(1.5, 2.5, 3));
    EXPECT_THAT(read(6, "hit", "2:1-3", "Question 6\n1t^2 - 6.5t 2.5e-01x or P3\n"), ElementsAre(2, 6.5, 0.25));
}

TEST(ItemPlace, MayRunOverSeveralLines) {
    EXPECT_THAT(read(6, "hit", "2-4", "Question 6\n1\nthen 2\nand 3\n"), ElementsAre(1, 2, 3));
}

TEST(ItemPlace, HoldsNothingWhereTheCountDiffers) {
    const std::string output = "Question 6\nfoo 1 bar 2\n";
    EXPECT_THAT(read(6, "hit", "2", output), testing::IsEmpty());
    EXPECT_THAT(read(6, "t", "2:3", output), testing::IsEmpty());
    EXPECT_THAT(read(6, "t", "7", output), testing::IsEmpty());
}

TEST(ItemPlace, MayHoldASentence) {
    Transcript transcript = read_transcript("The winner: triangle first\n", 10);
    const auto item =
        read_at(transcript, spec_of(10, "verdict"), place(10, "verdict", "1"), reference::default_items());
    ASSERT_TRUE(item && item->first_object);
    EXPECT_EQ(item->first_object->object, reference::FirstObject(reference::Subject::triangle));
}

TEST(Match, ReadsAnItemFromItsPlaceAndLeavesTheValueToNoOther) {
    const std::string output = "Question 6\na: 1\nb: 2\nc: 3\nd: 4\n5.5\n6.5\n";
    EXPECT_THAT(matched(6, "t", output, {}), ElementsAre(5.5));
    EXPECT_THAT(matched(6, "t", output, {place(6, "t", "7")}), ElementsAre(6.5));
    EXPECT_THAT(matched(6, "d", output, {place(6, "t", "5")}), testing::Not(ElementsAre(4)))
        << "line 5 is read for t alone";
}

TEST(Match, LeavesNumbersThatWereReadByTheirPlaceToNoOtherItem) {
    const std::string output = "Question 6\nfoo bar 1 2 3\nqux 4\n";
    ASSERT_THAT(matched(6, "a", output, {}), ElementsAre(1)) << "the list was read as a, b and c";
    EXPECT_THAT(matched(6, "hit", output, {place(6, "hit", "2:1-3")}), ElementsAre(1, 2, 3));
    for (const char* item : {"a", "b", "c"})
        EXPECT_THAT(matched(6, item, output, {place(6, "hit", "2:1-3")}), testing::Not(testing::Contains(1))) << item;
}

TEST(Match, LeavesTheRestOfAListToTheOtherItems) {
    const std::string output = "Question 6\na, b, c, d: 5 5 7 5\n";
    const std::vector<ItemPlace> one = {place(6, "b", "2:2")};
    EXPECT_THAT(matched(6, "a", output, one), ElementsAre(5));
    EXPECT_THAT(matched(6, "c", output, one), ElementsAre(7));
    EXPECT_THAT(matched(6, "d", output, one), ElementsAre(5));
    const std::vector<ItemPlace> three = {place(6, "a", "2:1"), place(6, "b", "2:2"), place(6, "d", "2:4")};
    EXPECT_THAT(matched(6, "c", output, three), ElementsAre(7)) << "equal numbers are taken once each";
}

TEST(Match, FindsAnswersUnderTheHeadingOfAQuestionWhoseOnlyItemHasAPlace) {
    const std::string output = "Question 5\nV = (0, 0, -1)\na: 1\nt: 3\nnormal: (0, 0, 1)\n";
    for (const char* lines : {"2", ""}) {
        EXPECT_THAT(matched(6, "t", output, {place(5, "V", lines)}), ElementsAre(3)) << lines;
        EXPECT_THAT(matched(7, "normal", output, {place(5, "V", lines)}), ElementsAre(0, 0, 1)) << lines;
    }
}

TEST(Match, GivesTheValueOfAnItemThatWasNotPrintedToAnother) {
    const std::string output = "Question 4\n(1, 2, 3)\nQuestion 1\nP_VCS (4, 5, 6)\n";
    EXPECT_THAT(matched(4, "P_WCS", output, {}), ElementsAre(1, 2, 3));
    EXPECT_THAT(matched(4, "P_WCS", output, {place(4, "P_WCS", "")}), testing::IsEmpty());
}

}  // namespace
}  // namespace harness
