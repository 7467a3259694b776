#include "reference/cast/blocks.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <istream>
#include <limits>
#include <mutex>
#include <optional>
#include <ostream>
#include <string_view>
#include <thread>
#include <vector>

namespace reference::cast {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18U;

/// Appends what has come in, up to a block. Waits for the first byte; false at the end of the input.
bool append_some(std::istream& in, std::string& bytes) {
    if (in.peek() == std::istream::traits_type::eof()) return false;
    const auto most = static_cast<std::streamsize>(block_bytes);
    const std::streamsize there = std::clamp<std::streamsize>(in.rdbuf()->in_avail(), 1, most);
    const std::size_t before = bytes.size();
    bytes.resize(before + static_cast<std::size_t>(there));
    in.read(bytes.data() + before, there);
    bytes.resize(before + static_cast<std::size_t>(in.gcount()));
    return true;
}

bool has_more(std::istream& in) {
    return in.rdbuf()->in_avail() > 0;
}

/// Leaves the first `size` bytes, and moves the others to `rest`.
void split(std::string& bytes, std::size_t size, std::string& rest) {
    rest.assign(bytes, size);
    bytes.resize(size);
}

/// Ends the block after longest_line + 1 bytes and skips the rest of the line.
void cut_off(std::istream& in, std::string& bytes) {
    bytes.resize(longest_line + 1);
    bytes.push_back('\n');
    in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
}

}  // namespace

bool LineBlocks::next(Block& block) {
    block.bytes.swap(rest_);
    rest_.clear();
    block.first = next_line_;
    std::size_t complete = 0;  // bytes up to the end of the last whole line
    while (complete == 0 || (block.bytes.size() < block_bytes && has_more(in_))) {
        const std::size_t before = block.bytes.size();
        if (!append_some(in_, block.bytes)) {
            complete = block.bytes.size();
            break;
        }
        const std::size_t end = std::string_view(block.bytes).substr(before).rfind('\n');
        if (end != std::string_view::npos) complete = before + end + 1;
        if (complete == 0 && block.bytes.size() > longest_line) {
            cut_off(in_, block.bytes);
            complete = block.bytes.size();
        }
    }
    split(block.bytes, complete, rest_);
    next_line_ += static_cast<std::uint64_t>(std::count(block.bytes.begin(), block.bytes.end(), '\n'));
    return !block.bytes.empty();
}

bool RecordBlocks::next(Block& block) {
    block.bytes.swap(rest_);
    rest_.clear();
    block.first = next_record_;
    while (block.bytes.size() < record_bytes_ || (block.bytes.size() < block_bytes && has_more(in_))) {
        if (!append_some(in_, block.bytes)) break;
    }
    split(block.bytes, block.bytes.size() - block.bytes.size() % record_bytes_, rest_);
    next_record_ += block.bytes.size() / record_bytes_;
    return !block.bytes.empty();
}

long answer_in_order(const std::function<bool(Block&)>& next, const std::function<Worker()>& new_worker,
                     std::ostream& answers, int jobs) {
    std::mutex taking;
    std::uint64_t taken = 0;
    std::mutex writing;
    std::condition_variable turn;
    std::uint64_t written = 0;
    long malformed = 0;
    bool is_over = false;
    std::exception_ptr failure;

    const auto take = [&](Block& block) -> std::optional<std::uint64_t> {
        const std::lock_guard lock(taking);
        if (!next(block)) return std::nullopt;
        return taken++;
    };
    // Returns whether to go on.
    const auto write = [&](std::uint64_t number, const Text& text, long malformed_in_it) {
        std::unique_lock lock(writing);
        turn.wait(lock, [&] { return is_over || written == number; });
        if (is_over) return false;
        answers.write(text.data(), static_cast<std::streamsize>(text.size())).flush();
        malformed += malformed_in_it;
        ++written;
        is_over = !answers;
        turn.notify_all();
        return !is_over;
    };
    const auto work = [&] {
        try {
            const Worker worker = new_worker();
            Block block;
            Text text;
            while (const auto number = take(block)) {
                text.clear();
                const long malformed_in_it = worker(block, text);
                if (!write(*number, text, malformed_in_it)) return;
            }
        } catch (...) {
            const std::lock_guard lock(writing);
            is_over = true;
            if (!failure) failure = std::current_exception();
            turn.notify_all();
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int i = 1; i < jobs; ++i) threads.emplace_back(work);
        work();
    }
    if (failure) std::rethrow_exception(failure);
    return malformed;
}

}  // namespace reference::cast
