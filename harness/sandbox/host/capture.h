// Reads a program's pipe to its end, in bounded memory.
#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "harness/machine/file_descriptor.h"

namespace harness {

/// Keeps the first `limit` bytes of a pipe; reads the rest and drops it. Reads while the io_context runs.
class Capture {
  public:
    Capture(boost::asio::io_context& io, FileDescriptor pipe, std::uint64_t limit);

    /// Starts reading. `on_more` is called once if there is more than the limit; `on_end` once, at the pipe's end or
    /// after stop().
    void start(std::function<void()> on_more, std::function<void()> on_end);
    /// Closes the pipe without reading the rest.
    void stop();
    /// Whether there was more than the limit.
    bool truncated() const { return truncated_; }
    /// The kept bytes. Call it once, after the end.
    std::string take() { return std::move(kept_); }

  private:
    void read_on();
    void keep(std::size_t size);

    boost::asio::posix::stream_descriptor pipe_;
    std::uint64_t limit_;
    std::array<char, 16384> buffer_{};
    std::string kept_;
    bool truncated_ = false;
    std::function<void()> on_more_, on_end_;
};

}  // namespace harness
