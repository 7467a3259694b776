#include "harness/shards/shard.h"

#include <charconv>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "harness/build/header_use.h"
#include "harness/machine/fingerprint.h"

namespace harness {
namespace {

std::optional<int> read_number(std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1 || number > Shard::most) return {};
    return number;
}

/// The order of a source when the class is split. It uses hashes, so that students cannot choose their shard, and long
/// sources are spread over all shards.
std::pair<std::string, std::string> order_of(const Submission& submission) {
    if (submission.problem) return {};
    Fingerprint header("raygrade/shard/1");
    for (const std::string& line : header_use(submission.source).lines) header.add(line);
    return {header.hex(), Fingerprint("raygrade/shard/1").add(submission.source).hex()};
}

}  // namespace

std::optional<Shard> read_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto number = read_number(text.substr(0, slash)), count = read_number(text.substr(slash + 1));
    if (!number || !count || *number > *count) return std::nullopt;
    return Shard{*number, *count};
}

std::vector<int> split(const std::vector<Submission>& submissions, int count) {
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> alike;
    for (std::size_t i = 0; i < submissions.size(); ++i) alike[order_of(submissions[i])].push_back(i);
    std::vector<int> shards(submissions.size(), 1);
    std::size_t before = 0;
    for (const auto& [order, members] : alike) {
        // Uses the middle of the group; twice the middle is a whole number.
        const std::size_t middle = 2 * before + members.size();
        const std::size_t shard = middle * static_cast<std::size_t>(count) / (2 * submissions.size());
        for (const std::size_t member : members) shards[member] = static_cast<int>(shard) + 1;
        before += members.size();
    }
    return shards;
}

}  // namespace harness
