// A server for tests, at a free port of 127.0.0.1. No program is graded unless the test grades it.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "harness/serve/http/server.h"
#include "harness/serve/http/server_limits.h"
#include "harness/serve/queue/queue.h"
#include "harness/serve/site/site.h"
#include "tests/given/serve/client.h"

namespace harness::serve {

class RunningServer {
  public:
    struct Options {
        ServerLimits limits{};
        std::size_t queue = 100;
        Reach reach{};
    };
    RunningServer() : RunningServer(Options()) {}
    explicit RunningServer(const Options& options);
    ~RunningServer();
    RunningServer(const RunningServer&) = delete;
    RunningServer& operator=(const RunningServer&) = delete;

    std::uint16_t port() const { return server_->port(); }
    HttpAnswer ask(std::string_view request) const { return serve::ask(port(), request); }
    /// Whether the server accepts a further connection within the time.
    bool has_room_within(std::chrono::milliseconds time) const;
    Queue& queue() { return *queue_; }
    /// The folder of the spool.
    const std::filesystem::path& folder() const { return folder_; }
    void stop() { server_->stop(); }
    /// Waits until the server has ended by itself.
    void join() { thread_.join(); }

  private:
    std::filesystem::path folder_;
    std::unique_ptr<KeptPrograms> kept_programs_;
    std::unique_ptr<Queue> queue_;
    std::unique_ptr<Site> site_;
    std::unique_ptr<Server> server_;
    std::thread thread_;
};

}  // namespace harness::serve
