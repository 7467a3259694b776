#include "harness/sandbox/supervisor/process_tree.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "harness/machine/file_descriptor.h"

namespace harness {
namespace {

/// Reads a small file of /proc, which returns its whole text in one read.
std::string read_small_file(int folder, const char* name) {
    const FileDescriptor file(openat(folder, name, O_RDONLY | O_CLOEXEC));
    if (!file) return {};
    char text[4096];
    const ssize_t size = read(file.get(), text, sizeof text);
    return size > 0 ? std::string(text, static_cast<std::size_t>(size)) : std::string();
}

/// The fields of a stat line from the third on (proc(5) counts from 1). The program chooses the second field, the name
/// in parentheses, which may contain blanks and parentheses. So this looks for the last closing parenthesis.
std::vector<std::string_view> stat_fields(std::string_view line) {
    std::vector<std::string_view> fields;
    std::size_t at = line.rfind(')');
    if (at == std::string_view::npos) return fields;
    for (at += 2; at < line.size();) {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        fields.push_back(line.substr(at, end - at));
        at = end + 1;
    }
    return fields;
}

std::int64_t number(std::string_view text) {
    std::int64_t value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

ProcessRecord to_record(const std::vector<std::string_view>& fields, pid_t pid) {
    static const std::int64_t ticks_per_second = sysconf(_SC_CLK_TCK);
    static const std::int64_t page_bytes = sysconf(_SC_PAGESIZE);
    const auto field = [&](std::size_t as_in_the_manual) { return number(fields[as_in_the_manual - 3]); };
    ProcessRecord record;
    record.pid = pid;
    record.living_thread = pid;
    record.parent = static_cast<pid_t>(field(4));
    record.group = static_cast<pid_t>(field(5));
    record.zombie = fields[0] == "Z" || fields[0] == "X";
    record.cpu = std::chrono::milliseconds((field(14) + field(15) + field(16) + field(17)) * 1000 / ticks_per_second);
    record.threads = static_cast<int>(field(20));
    record.memory_bytes = static_cast<std::uint64_t>(field(24) * page_bytes);
    return record;
}

/// Reads the record of a process, or of a thread with its process's memory. Empty if it does not exist (any more).
std::optional<ProcessRecord> read_entry(int proc, pid_t pid) {
    const std::string line = read_small_file(proc, (std::to_string(pid) + "/stat").c_str());
    const auto fields = stat_fields(line);
    if (fields.size() < 22) return std::nullopt;
    return to_record(fields, pid);
}

/// If the first thread of a process has ended, the process looks like a zombie without memory. Its other threads show
/// whether it lives.
void look_at_other_threads(int proc, ProcessRecord& record) {
    const std::string tasks = std::to_string(record.pid) + "/task";
    const int descriptor = openat(proc, tasks.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(descriptor < 0 ? nullptr : fdopendir(descriptor), closedir);
    while (const dirent* entry = folder ? readdir(folder.get()) : nullptr) {
        const auto thread = read_entry(proc, static_cast<pid_t>(std::atoi(entry->d_name)));
        if (!thread || thread->zombie) continue;
        record.zombie = false;
        record.living_thread = thread->pid;
        record.memory_bytes = thread->memory_bytes;
        return;
    }
}

std::optional<ProcessRecord> read_record(int proc, pid_t pid) {
    auto record = read_entry(proc, pid);
    if (record && record->zombie && record->threads > 1) look_at_other_threads(proc, *record);
    return record;
}

FileDescriptor open_proc() {
    return FileDescriptor(open("/proc", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
}

bool by_parent(const ProcessRecord& a, const ProcessRecord& b) {
    return a.parent < b.parent;
}

/// The kernel kills a group in one step, which no fork can escape. Killing processes one by one is slower than a fork
/// bomb.
void kill_group(pid_t group) {
    if (group > 1 && group != getpgrp()) kill(-group, SIGKILL);
}

/// An orphan that forks and exits in a loop lives for about 100 µs and is gone before a walk through /proc reaches it.
/// It is a child of `root`, and its number is near the latest one, which /proc/loadavg shows.
void kill_newest_children(int proc, pid_t root) {
    const std::string load = read_small_file(proc, "loadavg");
    const auto newest = static_cast<pid_t>(number(std::string_view(load).substr(load.rfind(' ') + 1)));
    for (pid_t pid = newest; pid > std::max(newest - 8, 1); --pid) {
        const auto record = read_record(proc, pid);
        if (record && record->parent == root) kill_group(record->group);
    }
}

}  // namespace

std::vector<ProcessRecord> list_processes() {
    std::vector<pid_t> none;
    return list_processes_except(none);
}

std::vector<ProcessRecord> list_processes_except(std::vector<pid_t>& strangers) {
    std::vector<ProcessRecord> processes;
    std::vector<pid_t> seen;
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(opendir("/proc"), closedir);
    while (const dirent* entry = folder ? readdir(folder.get()) : nullptr) {
        const auto pid = static_cast<pid_t>(std::atoi(entry->d_name));
        if (pid <= 0) continue;
        if (std::binary_search(strangers.begin(), strangers.end(), pid)) {
            seen.push_back(pid);
        } else if (const auto record = read_record(dirfd(folder.get()), pid)) {
            processes.push_back(*record);
        }
    }
    std::sort(seen.begin(), seen.end());
    strangers = std::move(seen);
    return processes;
}

std::vector<ProcessRecord> below(pid_t root, std::vector<ProcessRecord> processes) {
    std::sort(processes.begin(), processes.end(), by_parent);
    std::vector<ProcessRecord> found;
    const auto add_children_of = [&](pid_t parent) {
        ProcessRecord wanted;
        wanted.parent = parent;
        const auto [first, last] = std::equal_range(processes.begin(), processes.end(), wanted, by_parent);
        found.insert(found.end(), first, last);
    };
    add_children_of(root);
    // The list is not a snapshot: a number reused during one walk could close a cycle, hence the bound.
    for (std::size_t i = 0; i < found.size() && found.size() <= processes.size(); ++i) add_children_of(found[i].pid);
    return found;
}

std::uint64_t hidden_memory_bytes(const ProcessRecord& process) {
    const std::string status =
        read_small_file(open_proc().get(), (std::to_string(process.living_thread) + "/status").c_str());
    std::uint64_t kib = 0;
    for (const std::string_view name : {"\nVmPTE:", "\nVmSwap:"}) {
        const std::size_t at = status.find(name);
        if (at == std::string::npos) continue;
        const std::size_t digits = std::min(status.find_first_not_of(" \t", at + name.size()), status.size());
        kib += static_cast<std::uint64_t>(number(std::string_view(status).substr(digits)));
    }
    return kib * 1024;
}

void kill_below(pid_t root) {
    if (root < 1) return;
    const FileDescriptor proc = open_proc();
    kill_newest_children(proc.get(), root);
    std::set<pid_t> groups;
    const auto processes = below(root, list_processes());
    for (const auto& process : processes) {
        // Once per group: killing a group of a thousand a thousand times would keep the kernel busy for minutes.
        if (groups.insert(process.group).second) kill_group(process.group);
    }
    for (const auto& process : processes) {
        if (!process.zombie) kill(process.pid, SIGKILL);
    }
}

}  // namespace harness
