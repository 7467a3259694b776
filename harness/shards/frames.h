// Lists of texts in a file that goes from one machine to another. Each list has a seal, which covers all lists before
// it, so that a reader sees what was cut off, garbled, left out or put in. The seal guards against accidents of disks
// and networks, not against a person who writes such a file.
#pragma once

#include <cstdint>
#include <istream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

/// Thrown for a file that can't be read on; what() is a clause: "is cut off".
class DamagedFile : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Frame {
    std::string word;  ///< what the texts are; lower-case letters
    std::vector<std::string> texts;
};

class FrameWriter {
  public:
    /// Writes `head` as the first line.
    FrameWriter(std::ostream& stream, const std::string& head);
    void write(const Frame& frame);

  private:
    std::ostream& stream_;
    std::string seal_;
};

class FrameReader {
  public:
    static constexpr std::uintmax_t longest_head = std::uintmax_t{1} << 20U;
    static constexpr std::uintmax_t longest_text = std::uintmax_t{64} << 20U;  ///< as much as a list of students
    static constexpr std::size_t most_texts = 8;

    /// Reads the first line; `size` is that of the file. Throws DamagedFile.
    FrameReader(std::istream& stream, std::uintmax_t size);
    const std::string& head() const { return head_; }
    /// Throws DamagedFile.
    Frame next();
    bool is_at_end() const { return left_ == 0; }

  private:
    std::string read_line(std::uintmax_t longest);

    std::istream& stream_;
    std::uintmax_t left_;  ///< bytes of the file that were not read
    std::string head_, seal_;
};

}  // namespace harness
