// Blocks are whole lines or records whatever way the input comes in, and answers keep their order.
#include "reference/cast/blocks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <thread>
#include <vector>

namespace {

using namespace reference::cast;

/// Gives its parts one at a time, as a pipe does. Before each it calls `before`.
class Parts : public std::streambuf {
  public:
    explicit Parts(std::vector<std::string> parts, std::function<void()> before = {})
        : parts_(std::move(parts)), before_(std::move(before)) {}

  private:
    int_type underflow() override {
        if (before_) before_();
        if (next_ == parts_.size()) return traits_type::eof();
        std::string& part = parts_[next_++];
        setg(part.data(), part.data(), part.data() + part.size());
        return traits_type::to_int_type(part.front());
    }

    std::vector<std::string> parts_;
    std::function<void()> before_;
    std::size_t next_ = 0;
};

std::vector<Block> all_of(auto& blocks) {
    std::vector<Block> all;
    for (Block block; blocks.next(block);) all.push_back(block);
    return all;
}

std::string joined(const std::vector<Block>& blocks) {
    std::string text;
    for (const Block& block : blocks) text += block.bytes;
    return text;
}

TEST(LineBlocks, AreWholeLinesWithTheirNumbers) {
    Parts parts({"on", "e\ntw", "o\nthree\n", "\n", "last"});
    std::istream in(&parts);
    LineBlocks lines(in);
    const std::vector<Block> blocks = all_of(lines);
    EXPECT_EQ(joined(blocks), "one\ntwo\nthree\n\nlast");
    std::uint64_t number = 1;
    for (const Block& block : blocks) {
        EXPECT_EQ(block.first, number);
        EXPECT_TRUE(&block == &blocks.back() || block.bytes.back() == '\n') << block.bytes;
        number += static_cast<std::uint64_t>(std::count(block.bytes.begin(), block.bytes.end(), '\n'));
    }
    EXPECT_EQ(number, 5U);
}

TEST(LineBlocks, AreBoundedForAnInputOfAnySize) {
    std::string text;
    for (int i = 0; i < 500'000; ++i) text += std::to_string(i) + '\n';
    std::istringstream in(text);
    LineBlocks lines(in);
    const std::vector<Block> blocks = all_of(lines);
    EXPECT_GT(blocks.size(), 5U);
    for (const Block& block : blocks) EXPECT_LT(block.bytes.size(), std::size_t{1} << 20U);
    EXPECT_EQ(joined(blocks), text);
}

TEST(LineBlocks, CutOffALineWithoutEnd) {
    const std::string mebibyte(std::size_t{1} << 20U, 'x');
    std::vector<std::string> parts(70, mebibyte);
    parts.insert(parts.begin(), "first\n");
    parts.emplace_back("x\nlast\n");
    Parts given(parts);
    std::istream in(&given);
    LineBlocks lines(in);
    Block block;
    ASSERT_TRUE(lines.next(block));
    EXPECT_EQ(block.bytes, "first\n");
    ASSERT_TRUE(lines.next(block));
    EXPECT_EQ(block.bytes.size(), longest_line + 2);
    EXPECT_EQ(block.first, 2U);
    ASSERT_TRUE(lines.next(block));
    EXPECT_EQ(block.bytes, "last\n");
    EXPECT_EQ(block.first, 3U);
    EXPECT_FALSE(lines.next(block));
}

TEST(RecordBlocks, AreWholeRecordsAndTellWhatIsLeftOver) {
    for (const std::size_t more : {0U, 1U, 3U}) {
        Parts parts({"aaaab", "b", "bbccccdd", "dd" + std::string("eee", more)});
        std::istream in(&parts);
        RecordBlocks records(in, 4);
        const std::vector<Block> blocks = all_of(records);
        EXPECT_EQ(joined(blocks), "aaaabbbbccccdddd");
        std::uint64_t number = 1;
        for (const Block& block : blocks) {
            EXPECT_EQ(block.first, number);
            EXPECT_EQ(block.bytes.size() % 4, 0U);
            number += block.bytes.size() / 4;
        }
        EXPECT_EQ(records.records(), 4U);
        EXPECT_EQ(records.left_over(), more);
    }
}

/// Repeats the block, later for earlier blocks. Calls each block malformed once.
Worker slow_echo() {
    return [](const Block& block, Text& text) {
        std::this_thread::sleep_for(std::chrono::microseconds(200 * (block.first % 3)));
        text.append(block.bytes.data(), block.bytes.data() + block.bytes.size());
        return 1;
    };
}

TEST(AnswerInOrder, KeepsTheOrderForAnyNumberOfThreads) {
    std::vector<std::string> lines;
    std::string text;
    for (int i = 0; i < 200; ++i) text += lines.emplace_back(std::to_string(i) + '\n');
    for (const int jobs : {1, 2, 3, 16}) {
        Parts parts(lines);
        std::istream in(&parts);
        LineBlocks blocks(in);
        std::ostringstream out;
        EXPECT_EQ(answer_in_order([&](Block& block) { return blocks.next(block); }, slow_echo, out, jobs), 200);
        EXPECT_EQ(out.str(), text);
    }
}

TEST(AnswerInOrder, AnswersWhatHasComeInBeforeItWaitsForMore) {
    std::ostringstream out;
    std::vector<std::string> answered;
    Parts parts({"1\n2\n", "3\n", "4\n"}, [&] { answered.push_back(out.str()); });
    std::istream in(&parts);
    LineBlocks blocks(in);
    answer_in_order([&](Block& block) { return blocks.next(block); }, slow_echo, out, 1);
    EXPECT_EQ((std::vector<std::string>(answered.begin(), answered.begin() + 4)),
              (std::vector<std::string>{"", "1\n2\n", "1\n2\n3\n", "1\n2\n3\n4\n"}));
}

/// A disk that is full.
class Full : public std::streambuf {
    int_type overflow(int_type /*next*/) override { return traits_type::eof(); }
};

TEST(AnswerInOrder, EndsWhereTheAnswersCannotBeWritten) {
    Full full;
    std::ostream out(&full);
    std::atomic<int> taken = 0;
    const auto endless = [&](Block& block) {
        block = {"1\n", static_cast<std::uint64_t>(++taken)};
        return true;
    };
    answer_in_order(endless, slow_echo, out, 3);
    EXPECT_FALSE(out);
    EXPECT_LE(taken, 6);
}

TEST(AnswerInOrder, PassesOnWhatAWorkerThrows) {
    for (const int jobs : {1, 4}) {
        std::ostringstream out;
        std::uint64_t taken = 0;
        const auto endless = [&](Block& block) {
            block = {"1\n", ++taken};
            return true;
        };
        const auto failing = [] {
            return [](const Block& block, Text& /*text*/) -> long {
                if (block.first == 20) throw std::runtime_error("broken");
                return 0;
            };
        };
        EXPECT_THROW(answer_in_order(endless, failing, out, jobs), std::runtime_error);
    }
}

}  // namespace
