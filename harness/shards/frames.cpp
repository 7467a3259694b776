#include "harness/shards/frames.h"

#include <charconv>
#include <sstream>

#include "harness/machine/fingerprint.h"

namespace harness {
namespace {

std::string seal_of(const std::string& before, const Frame& frame) {
    Fingerprint seal("raygrade/frame/1");
    seal.add(before).add(frame.word).add(static_cast<std::int64_t>(frame.texts.size()));
    for (const std::string& text : frame.texts) seal.add(text);
    return seal.hex();
}

std::string first_seal(const std::string& head) {
    return seal_of(head, {});
}

[[noreturn]] void fail(const char* how) {
    throw DamagedFile(how);
}

std::uintmax_t size_called(const std::string& word) {
    std::uintmax_t size = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), size);
    if (error != std::errc() || end != word.data() + word.size()) fail("is damaged");
    return size;
}

}  // namespace

FrameWriter::FrameWriter(std::ostream& stream, const std::string& head) : stream_(stream), seal_(first_seal(head)) {
    stream_ << head << '\n';
}

void FrameWriter::write(const Frame& frame) {
    seal_ = seal_of(seal_, frame);
    stream_ << frame.word;
    for (const std::string& text : frame.texts) stream_ << ' ' << text.size();
    stream_ << ' ' << seal_ << '\n';
    for (const std::string& text : frame.texts) stream_ << text;
}

FrameReader::FrameReader(std::istream& stream, std::uintmax_t size)
    : stream_(stream), left_(size), head_(read_line(longest_head)), seal_(first_seal(head_)) {}

std::string FrameReader::read_line(std::uintmax_t longest) {
    std::string line;
    for (char c = 0; left_ > 0 && stream_.get(c);) {
        --left_;
        if (c == '\n') return line;
        if (line.size() == longest) fail("is damaged");
        line += c;
    }
    fail("is cut off");
}

Frame FrameReader::next() {
    constexpr std::uintmax_t longest_line = 512;
    std::istringstream line(read_line(longest_line));
    Frame frame;
    std::vector<std::string> words;
    line >> frame.word;
    for (std::string word; line >> word;) words.push_back(word);
    if (words.empty() || words.size() > most_texts + 1) fail("is damaged");
    const std::string seal = std::move(words.back());
    words.pop_back();
    for (const std::string& word : words) {
        const std::uintmax_t size = size_called(word);
        if (size > longest_text) fail("is damaged");
        if (size > left_) fail("is cut off");
        std::string& text = frame.texts.emplace_back(static_cast<std::size_t>(size), '\0');
        if (!stream_.read(text.data(), static_cast<std::streamsize>(size))) fail("is cut off");
        left_ -= size;
    }
    seal_ = seal_of(seal_, frame);
    if (seal_ != seal) fail("is damaged");
    return frame;
}

}  // namespace harness
