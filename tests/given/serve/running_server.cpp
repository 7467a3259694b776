#include "tests/given/serve/running_server.h"

#include <stdexcept>

namespace harness::serve {

RunningServer::RunningServer(const Options& options) {
    std::string name = (std::filesystem::temp_directory_path() / "raygrade-test.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder " + name);
    folder_ = name;
    kept_programs_ = std::make_unique<KeptPrograms>(folder_);
    queue_ = std::make_unique<Queue>(*kept_programs_, options.queue);
    SiteSettings settings;
    settings.about.title = "An <assignment>";
    settings.about.keep = std::chrono::hours(24);
    settings.reach = options.reach;
    site_ = std::make_unique<Site>(settings, *queue_);
    server_ = std::make_unique<Server>("127.0.0.1", static_cast<std::uint16_t>(0), options.limits, *site_);
    thread_ = std::thread([this] { server_->run(); });
}

RunningServer::~RunningServer() {
    if (thread_.joinable()) {
        server_->stop();
        thread_.join();
    }
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

bool RunningServer::has_room_within(std::chrono::milliseconds time) const {
    const auto end = std::chrono::steady_clock::now() + time;
    int status = 0;
    while (status != 200 && std::chrono::steady_clock::now() < end) status = ask(get("/icon.svg")).status;
    return status == 200;
}

}  // namespace harness::serve
