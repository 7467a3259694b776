#include "tests/scenario/scenario.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace scenario {
namespace {

namespace fs = std::filesystem;

constexpr int could_not_prepare = 99;
constexpr int could_not_start = 98;

/// Lets a process without root rights mount in a namespace of its own, which nobody else sees.
bool become_root_of_a_namespace() {
    const std::string user = std::to_string(geteuid());
    const std::string group = std::to_string(getegid());
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
    std::ofstream("/proc/self/setgroups") << "deny";
    return static_cast<bool>(std::ofstream("/proc/self/uid_map") << "0 " + user + " 1" << std::flush) &&
           static_cast<bool>(std::ofstream("/proc/self/gid_map") << "0 " + group + " 1" << std::flush);
}

int wait_for(pid_t child) {
    using namespace std::chrono_literals;
    const auto deadline = std::chrono::steady_clock::now() + 240s;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > deadline) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            break;
        }
        std::this_thread::sleep_for(5ms);
    }
    constexpr int signal_base = 128;
    return WIFEXITED(status) ? WEXITSTATUS(status) : signal_base + WTERMSIG(status);
}

}  // namespace

void write(const fs::path& file, std::string_view text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("can't read " + file.string());
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

nlohmann::json read_json(const fs::path& file) {
    return nlohmann::json::parse(read(file));
}

fs::path project_folder() {
    return RAYGRADE_PROJECT;
}

fs::path sample(std::string_view who) {
    return project_folder() / "submissions" / who;
}

[[noreturn]] void become_raygrade(const std::vector<std::string>& arguments, const Preparation& prepare,
                                  const fs::path& output, const fs::path& voice) {
    const int in = open("/dev/null", O_RDONLY);
    const int out = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = open(voice.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) _exit(could_not_start);
    // A cache of its own, if `prepare` names none.
    setenv("XDG_CACHE_HOME", (voice.parent_path() / "cache").c_str(), 1);
    if (prepare && !prepare()) _exit(could_not_prepare);
    std::string name = RAYGRADE_BINARY;
    std::vector<std::string> words = arguments;
    std::vector<char*> argv{name.data()};
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    execv(RAYGRADE_BINARY, argv.data());
    _exit(could_not_start);
}

namespace {

Result run(const std::vector<std::string>& arguments, const Preparation& prepare) {
    const TemporaryFolder folder;
    const fs::path output = folder / "stdout";
    const fs::path voice = folder / "stderr";
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) become_raygrade(arguments, prepare, output, voice);
    const int status = wait_for(child);
    if (status == could_not_prepare) throw std::runtime_error("this machine does not allow what the test prepares");
    if (status == could_not_start) throw std::runtime_error("could not start " RAYGRADE_BINARY);
    return {status, read(output), read(voice)};
}

}  // namespace

Result raygrade(const std::vector<std::string>& arguments, const Preparation& prepare) {
    return run(arguments, both(with_cache(RAYGRADE_TEST_CACHE), prepare));
}

Result raygrade_from_scratch(const std::vector<std::string>& arguments, const Preparation& prepare) {
    const TemporaryFolder cache;
    return run(arguments, both(with_cache(cache.path()), prepare));
}

Preparation both(const Preparation& first, const Preparation& second) {
    return [first, second] { return first() && (!second || second()); };
}

Preparation with_cache(const fs::path& folder) {
    return [folder] { return setenv("XDG_CACHE_HOME", folder.c_str(), 1) == 0; };
}

bool obey_permissions() {
    if (geteuid() != 0) return true;
    return prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE) == 0 && prctl(PR_CAPBSET_DROP, CAP_DAC_READ_SEARCH) == 0;
}

bool mount_disk(const fs::path& folder, const std::string& size) {
    if (unshare(CLONE_NEWNS) != 0 && !become_root_of_a_namespace()) return false;
    // Make the mounts private first; otherwise the whole machine would see and keep the new mount.
    return mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           mount("disk", folder.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
}

bool mount_tiny_disk(const fs::path& folder) {
    return mount_disk(folder, "4096");
}

bool forget_path() {
    return setenv("PATH", "/nothing-is-here", 1) == 0;
}

bool holds_bwrap() {
    return raygrade({"doctor"}).output.find("programs run in: bwrap+shim") != std::string::npos;
}

nlohmann::json submission_in(const nlohmann::json& grades, std::string_view id) {
    for (const auto& submission : grades.at("submissions")) {
        if (submission.at("id") == id) return submission;
    }
    return nullptr;
}

std::set<std::string> item_names(const nlohmann::json& items) {
    std::set<std::string> names;
    for (const auto& item : items)
        names.insert(std::to_string(item.at("question").get<int>()) + "." + item.at("item").get<std::string>());
    return names;
}

}  // namespace scenario
