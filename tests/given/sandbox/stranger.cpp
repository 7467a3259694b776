#include "tests/given/sandbox/stranger.h"

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <map>
#include <thread>

#include "harness/sandbox/host/canary.h"

using namespace std::chrono_literals;

namespace {

harness::Limits wide_limits() {
    return {.cpu = 10s,
            .wall = 15s,
            .memory_bytes = 512 * mebibyte,
            .file_bytes = 16 * mebibyte,
            .stack_bytes = 8 * mebibyte,
            .output_bytes = 64 * 1024,
            .error_bytes = 1024,
            .processes = 16,
            .open_files = 64};
}

}  // namespace

std::shared_ptr<harness::Sandbox> sandbox_of(harness::Tier tier) {
    static std::map<harness::Tier, std::shared_ptr<harness::Sandbox>> made;
    auto& sandbox = made[tier];
    if (!sandbox) sandbox = std::make_shared<harness::Sandbox>(tier);
    return sandbox;
}

std::string why_not_here(harness::Tier tier) {
    if (tier == harness::Tier::unsafe) return "";
    return harness::try_canary(*sandbox_of(tier)).failure;
}

Stranger::Stranger(std::shared_ptr<harness::Sandbox> sandbox, std::vector<std::string> arguments)
    : sandbox_(std::move(sandbox)) {
    static std::atomic<int> count{0};
    mark_ = "RAYGRADE_TEST=" + std::to_string(getpid()) + '-' + std::to_string(count++);
    command.argv = {MISBEHAVE};
    command.argv.insert(command.argv.end(), arguments.begin(), arguments.end());
    command.working_directory = scratch_.path();
    command.account = scratch_.account();
    command.readable = {MISBEHAVE};
    command.environment = {mark_};
    command.limits = wide_limits();
}

int Stranger::alive() const {
    int found = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        std::ifstream file(entry.path() / "environ", std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        if (text.find(mark_ + '\0') != std::string::npos) ++found;
    }
    return found;
}

bool Stranger::waits_for(bool (*wanted)(int)) const {
    for (int i = 0; i < 500; ++i) {
        if (wanted(alive())) return true;
        std::this_thread::sleep_for(20ms);
    }
    return false;
}
