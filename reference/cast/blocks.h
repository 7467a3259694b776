// An input in blocks, and threads that answer them: the answers keep the order of the input, and no more than a block a
// thread is in memory. A block holds what has come in by then, so a program that sends a few queries and waits gets
// its answers.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>

namespace reference::cast {

/// Whole lines, or whole records.
struct Block {
    std::string bytes;
    std::uint64_t first;  ///< the number of its first line or record, counted from 1
};

/// A longer line is cut off after one byte more.
constexpr std::size_t longest_line = std::size_t{1} << 26U;

class LineBlocks {
  public:
    explicit LineBlocks(std::istream& in) : in_(in) {}
    /// False at the end of the input. The last line may lack its end; all others have theirs.
    bool next(Block& block);

  private:
    std::istream& in_;
    std::string rest_;  ///< the beginning of the next block's first line
    std::uint64_t next_line_ = 1;
};

class RecordBlocks {
  public:
    RecordBlocks(std::istream& in, std::size_t record_bytes) : in_(in), record_bytes_(record_bytes) {}
    /// False at the end of the input.
    bool next(Block& block);
    /// How many records there were so far.
    std::uint64_t records() const { return next_record_ - 1; }
    /// At the end of the input: how many bytes of a further record there are.
    std::size_t left_over() const { return rest_.size(); }

  private:
    std::istream& in_;
    std::size_t record_bytes_;
    std::string rest_;
    std::uint64_t next_record_ = 1;
};

using Text = fmt::memory_buffer;

/// Appends the answers to a block; returns how many queries in it were malformed. Used by one thread alone.
using Worker = std::function<long(const Block& block, Text& answers)>;

/// Answers the blocks that `next` gives until it returns false, on `jobs` >= 1 threads. Returns the sum of what the
/// workers return. Ends early if `answers` can't be written to.
long answer_in_order(const std::function<bool(Block&)>& next, const std::function<Worker()>& new_worker,
                     std::ostream& answers, int jobs);

}  // namespace reference::cast
