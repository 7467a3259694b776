#include "tests/scenario/hostile/decoys.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>

namespace hostile {
namespace {

namespace fs = std::filesystem;

const fs::path folder = "/tmp/raygrade-decoy";

/// The decoy files' contents by path.
const std::map<fs::path, std::string> files = {
    {folder / "answer_key.json", "DECOYKEY-7f3a91 P_VCS = (0, 0, -2)\n"},
    {folder / "gradebook.csv", "DECOYBOOK-5c20,ada,93\n"},
    {folder / "other/ray_cast.cpp",
     "// DECOYOTHER-e881\n#include <cstdio>\nint main() { std::puts(\"ESCAPED: another one's program\"); }\n"},
};

std::string read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void make_folder(const fs::path& path) {
    fs::create_directories(path);
    constexpr auto everyone = fs::perms::all;
    if (fs::status(path).permissions() != everyone) fs::permissions(path, everyone);
}

/// Writes by renaming, because a different test may be reading the file.
void make_file(const fs::path& path, const std::string& text) {
    constexpr auto everyone_may_write = static_cast<fs::perms>(0666);
    if (read(path) == text && fs::status(path).permissions() == everyone_may_write) return;
    const fs::path draft = "/tmp/raygrade-draft-" + std::to_string(getpid());
    std::ofstream(draft) << text;
    fs::permissions(draft, everyone_may_write);
    // The file must be older than every submission; otherwise a compiler warning would reveal it.
    fs::last_write_time(draft, fs::file_time_type::clock::now() - std::chrono::hours(24));
    fs::rename(draft, path);
}

harness::FileDescriptor listening(int family, const void* address, socklen_t size) {
    harness::FileDescriptor socket(::socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const int yes = 1;
    setsockopt(socket.get(), SOL_SOCKET, SO_REUSEPORT, &yes, sizeof yes);
    const bool listens =
        bind(socket.get(), static_cast<const sockaddr*>(address), size) == 0 && listen(socket.get(), 8) == 0;
    return listens ? std::move(socket) : harness::FileDescriptor();
}

bool called(const harness::FileDescriptor& socket) {
    return socket && static_cast<bool>(harness::FileDescriptor(accept(socket.get(), nullptr, nullptr)));
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

}  // namespace

void place_decoy_files() {
    make_folder(folder);
    make_folder(folder / "other");
    for (const auto& [path, text] : files) make_file(path, text);
}

std::vector<std::string> changes_to_decoy_files() {
    std::vector<std::string> changes;
    for (const auto& [path, text] : files) {
        if (read(path) != text) changes.push_back(path.string() + " holds something else");
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path() != folder / "other" && !files.contains(entry.path())) {
            changes.push_back(entry.path().string() + " is new");
        }
    }
    return changes;
}

DecoyListener::DecoyListener() {
    sockaddr_in tcp{};
    tcp.sin_family = AF_INET;
    tcp.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    constexpr in_port_t port = 47053;
    tcp.sin_port = htons(port);
    tcp_ = listening(AF_INET, &tcp, sizeof tcp);
    if (!tcp_) throw std::runtime_error("nobody can listen at 127.0.0.1:47053");
    sockaddr_un local{};
    local.sun_family = AF_UNIX;
    constexpr std::string_view name = "raygrade-decoy";
    std::memcpy(local.sun_path + 1, name.data(), name.size());
    local_ = listening(AF_UNIX, &local, static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size()));
}

bool DecoyListener::was_called() const {
    return called(tcp_) || called(local_);
}

DecoySegment::DecoySegment() : id_(shmget(IPC_PRIVATE, 4096, 0666)) {
    void* const memory = id_ < 0 ? nullptr : shmat(id_, nullptr, 0);
    if (memory == nullptr || memory == reinterpret_cast<void*>(-1)) {
        throw std::runtime_error("no shared memory can be made");
    }
    constexpr std::string_view text = "DECOYSHM-20c7";
    std::memcpy(memory, text.data(), text.size());
    shmdt(memory);
}

DecoySegment::~DecoySegment() {
    shmctl(id_, IPC_RMID, nullptr);
}

std::string stolen_word(std::string_view text) {
    // The last two are in the /etc/passwd of every Debian.
    constexpr std::string_view words[] = {"decoykey-7f3a91", "decoybook-5c20", "decoyother-e881",  "decoyshm-20c7",
                                          "decoyenv-91bb",   "root:x:0:0",     "/usr/sbin/nologin"};
    const std::string lower = lower_case(text);
    for (const std::string_view word : words) {
        if (lower.find(word) != std::string::npos) return std::string(word);
    }
    return {};
}

}  // namespace hostile
