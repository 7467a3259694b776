#include "harness/cluster/preflight.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"

namespace harness::cluster {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json to_json(const Node& node) {
    Json traits = Json::object();
    for (const Trait& trait : node.traits) traits[trait.what] = trait.value;
    return {{"schema", "raygrade/node/1"}, {"node", node.name}, {"alike", traits}};
}

Json read_first(const fs::path& file) {
    constexpr std::uintmax_t most = 65536;
    Json json = Json::parse(read_bounded(file, most, Links::refuse).bytes, nullptr, false);
    if (!json.is_object() || !json.contains("alike") || !json["alike"].is_object()) {
        throw HarnessError(file.string() + ": is damaged; remove it and grade all shards again.");
    }
    return json;
}

/// A link, unlike a rename, never replaces the file of another machine, also on NFS.
void publish(const Json& json, const fs::path& file) {
    fs::path mine = file;
    mine += fmt::format(".{}.{}", json["node"].get<std::string>(), getpid());
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
    if (!fs::exists(file, error)) publish(to_json(node), file);
    const Json first = read_first(file);
    std::string differs;
    for (const Trait& trait : node.traits) {
        if (first["alike"].value(trait.what, Json()) == Json(trait.value)) continue;
        differs += (differs.empty() ? "" : ", ") + trait.what;
    }
    if (differs.empty()) return "";
    return fmt::format("this machine, {}, differs from {}, which started first: {}", node.name,
                       first.value("node", Json("?")).dump(-1, ' ', false, Json::error_handler_t::replace), differs);
}

}  // namespace harness::cluster
