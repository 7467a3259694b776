#include "harness/cluster/preflight.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"
#include "harness/text/escape.h"
#include "harness/text/printable.h"

namespace harness::cluster {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Node read_first(const fs::path& file) {
    constexpr std::uintmax_t most = 65536;
    try {
        const Json json = Json::parse(read_bounded(file, most, Links::refuse).bytes);
        return {json.at("node").get<std::string>(), conditions_in(json.at("alike"))};
    } catch (const Json::exception&) {
        throw HarnessError(file.string() + ": is damaged; remove it and grade all shards again.");
    }
}

/// A link, unlike a rename, never replaces the file of another machine, also on NFS.
void publish(const Node& node, const fs::path& file) {
    const Json json{{"schema", "raygrade/node/1"}, {"node", node.name}, {"alike", to_json(node.conditions)}};
    fs::path mine = file;
    mine += fmt::format(".{}.{}", node.name, getpid());
    std::ofstream stream(mine, std::ios::binary);
    stream << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    stream.close();
    std::error_code error;
    if (stream) fs::create_hard_link(mine, file, error);
    std::error_code ignored;
    fs::remove(mine, ignored);
    if (!stream || !fs::exists(file, ignored)) throw HarnessError(file.string() + ": can't be written.");
}

}  // namespace

std::string difference_from_first(const Node& node, const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error)) publish(node, file);
    const Node first = read_first(file);
    std::string differs;
    for (const Difference& each : differences(node.conditions, first.conditions))
        differs += (differs.empty() ? "" : ", ") + each.what;
    if (differs.empty()) return "";
    return fmt::format("this machine, {}, differs from {}, which started first: {}", node.name, in_quotes(first.name),
                       escape_control(differs));
}

}  // namespace harness::cluster
