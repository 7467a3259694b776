#include "harness/sandbox/host/capture.h"

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <utility>

namespace harness {

using boost::system::error_code;

Capture::Capture(boost::asio::io_context& io, FileDescriptor pipe, std::uint64_t limit)
    : pipe_(io, pipe.release()), limit_(limit) {}

void Capture::start(std::function<void()> on_more, std::function<void()> on_end) {
    on_more_ = std::move(on_more);
    on_end_ = std::move(on_end);
    read_on();
}

void Capture::stop() {
    error_code ignored;
    pipe_.close(ignored);
}

// Reads one piece at a time: reading to the end in one operation would hang if a daemon keeps the pipe open.
void Capture::read_on() {
    pipe_.async_read_some(boost::asio::buffer(buffer_), [this](error_code error, std::size_t size) {
        if (size > 0) keep(size);
        if (!error && pipe_.is_open()) return read_on();
        on_end_();
    });
}

void Capture::keep(std::size_t size) {
    const std::size_t room = static_cast<std::size_t>(limit_) - kept_.size();
    kept_.append(buffer_.data(), std::min(size, room));
    if (size <= room || truncated_) return;
    truncated_ = true;
    on_more_();
}

}  // namespace harness
