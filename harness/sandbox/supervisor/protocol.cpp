#include "harness/sandbox/supervisor/protocol.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

namespace harness {
namespace {

constexpr std::array<std::string_view, 8> how_names = {"exited",       "signalled",     "cpu_limit",    "wall_limit",
                                                       "memory_limit", "process_limit", "lifeline_cut", "not_executed"};

using Words = std::multimap<std::string, std::string, std::less<>>;

/// Splits "name=value"; false when there is no '='.
bool add_word(Words& words, std::string_view text) {
    const std::size_t middle = text.find('=');
    if (middle == std::string_view::npos) return false;
    words.emplace(text.substr(0, middle), text.substr(middle + 1));
    return true;
}

/// Reads the word called `name` into `value`; false when it is missing or not a number.
template <class Number>
bool take(const Words& words, std::string_view name, Number& value) {
    const auto word = words.find(name);
    if (word == words.end()) return false;
    const char* const end = word->second.data() + word->second.size();
    const auto [stop, error] = std::from_chars(word->second.data(), end, value);
    return error == std::errc{} && stop == end;
}

template <class Duration>
bool take_duration(const Words& words, std::string_view name, Duration& value) {
    typename Duration::rep count{};
    const bool ok = take(words, name, count);
    value = Duration(count);
    return ok;
}

/// Reads "3,4,5".
bool take_descriptors(std::string_view text, StandardDescriptors& descriptors) {
    const char* at = text.data();
    const char* const end = at + text.size();
    for (int* const number : {&descriptors.input, &descriptors.output, &descriptors.errors}) {
        const auto [stop, error] = std::from_chars(at, end, *number);
        const bool is_last = number == &descriptors.errors;
        if (error != std::errc{} || (is_last ? stop != end : stop == end || *stop != ',')) return false;
        at = stop + 1;
    }
    return true;
}

bool take_tier(const Words& words, Tier& tier) {
    const auto word = words.find("tier");
    for (const Tier known : {Tier::bwrap, Tier::landlock, Tier::unsafe}) {
        if (word == words.end() || word->second != to_string(known)) continue;
        tier = known;
        return true;
    }
    return false;
}

template <class Number>
std::string word(std::string_view name, Number value) {
    return std::string(name) + '=' + std::to_string(value);
}

}  // namespace

std::vector<std::string> to_arguments(const SupervisorOrders& orders) {
    const Limits& limits = orders.limits;
    std::vector<std::string> arguments = {
        word("status-fd", orders.status_fd),
        word("lifeline-fd", orders.lifeline_fd),
        "tier=" + std::string(to_string(orders.tier)),
        word("compiling", orders.purpose == Purpose::compile ? 1 : 0),
        word("counted-alone", orders.counted_alone ? 1 : 0),
        word("has-input", orders.has_input ? 1 : 0),
        word("cpu-ms", limits.cpu.count()),
        word("wall-ms", limits.wall.count()),
        word("memory-bytes", limits.memory_bytes),
        word("file-bytes", limits.file_bytes),
        word("stack-bytes", limits.stack_bytes),
        word("processes", limits.processes),
        word("open-files", limits.open_files),
        "directory=" + orders.working_directory,
    };
    if (orders.account) {
        arguments.push_back(word("uid", orders.account->uid));
        arguments.push_back(word("gid", orders.account->gid));
    }
    for (const auto& path : orders.readable) arguments.push_back("readable=" + path);
    for (const StandardDescriptors& run : orders.further_runs) {
        arguments.push_back(word("further-run", run.input) + ',' + std::to_string(run.output) + ',' +
                            std::to_string(run.errors));
    }
    arguments.emplace_back("--");
    arguments.insert(arguments.end(), orders.argv.begin(), orders.argv.end());
    return arguments;
}

std::optional<SupervisorOrders> from_arguments(const std::vector<std::string>& arguments) {
    Words words;
    std::size_t i = 0;
    for (; i < arguments.size() && arguments[i] != "--"; ++i) {
        if (!add_word(words, arguments[i])) return std::nullopt;
    }
    const auto directory = words.find("directory");
    if (i + 1 >= arguments.size() || directory == words.end()) return std::nullopt;
    SupervisorOrders orders;
    Limits& limits = orders.limits;
    orders.working_directory = directory->second;
    orders.argv.assign(arguments.begin() + static_cast<std::ptrdiff_t>(i) + 1, arguments.end());
    const auto [first, last] = words.equal_range("readable");
    for (auto word = first; word != last; ++word) orders.readable.push_back(word->second);
    const auto [first_run, last_run] = words.equal_range("further-run");
    for (auto word = first_run; word != last_run; ++word) {
        if (!take_descriptors(word->second, orders.further_runs.emplace_back())) return std::nullopt;
    }
    int compiling = 0;
    int counted_alone = 0;
    int has_input = 0;
    Account account;
    const bool complete =
        take(words, "status-fd", orders.status_fd) && take(words, "lifeline-fd", orders.lifeline_fd) &&
        take_tier(words, orders.tier) && take(words, "compiling", compiling) &&
        take(words, "counted-alone", counted_alone) && take(words, "has-input", has_input) &&
        take_duration(words, "cpu-ms", limits.cpu) && take_duration(words, "wall-ms", limits.wall) &&
        take(words, "memory-bytes", limits.memory_bytes) && take(words, "file-bytes", limits.file_bytes) &&
        take(words, "stack-bytes", limits.stack_bytes) && take(words, "processes", limits.processes) &&
        take(words, "open-files", limits.open_files) &&
        (!words.contains("uid") || (take(words, "uid", account.uid) && take(words, "gid", account.gid)));
    if (!complete) return std::nullopt;
    orders.purpose = compiling != 0 ? Purpose::compile : Purpose::run;
    orders.counted_alone = counted_alone != 0;
    orders.has_input = has_input != 0;
    if (words.contains("uid")) orders.account = account;
    return orders;
}

std::string to_line(const SupervisorStatus& status) {
    return "how=" + std::string(how_names[static_cast<std::size_t>(status.how)]) + ' ' + word("number", status.number) +
           ' ' + word("cpu-us", status.cpu.count()) + ' ' + word("wall-us", status.wall.count()) + ' ' +
           word("peak-bytes", status.peak_memory_bytes) + ' ' +
           word("out-of-memory", status.machine_ran_out_of_memory ? 1 : 0) + " step=" + status.step + '\n';
}

std::optional<SupervisorStatus> from_line(std::string_view line) {
    if (!line.ends_with('\n')) return std::nullopt;
    line.remove_suffix(1);
    if (line.find('\n') != std::string_view::npos) return std::nullopt;
    Words words;
    while (!line.empty()) {
        const std::size_t end = std::min(line.find(' '), line.size());
        if (!add_word(words, line.substr(0, end))) return std::nullopt;
        line.remove_prefix(std::min(end + 1, line.size()));
    }
    SupervisorStatus status;
    int out_of_memory = 0;
    const bool complete =
        take(words, "number", status.number) && take_duration(words, "cpu-us", status.cpu) &&
        take_duration(words, "wall-us", status.wall) && take(words, "peak-bytes", status.peak_memory_bytes) &&
        take(words, "out-of-memory", out_of_memory) && words.contains("step") && words.contains("how");
    if (!complete) return std::nullopt;
    status.machine_ran_out_of_memory = out_of_memory != 0;
    status.step = words.find("step")->second;
    for (std::size_t i = 0; i < how_names.size(); ++i) {
        if (how_names[i] != words.find("how")->second) continue;
        status.how = static_cast<SupervisorStatus::How>(i);
        return status;
    }
    return std::nullopt;
}

}  // namespace harness
