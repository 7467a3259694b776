#include "harness/shards/conditions.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness/build/toolchain.h"

namespace harness {
namespace {

const Condition* find(const std::vector<Condition>& conditions, const std::string& what) {
    const auto found = std::ranges::find(conditions, what, &Condition::what);
    return found == conditions.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Condition> machine_conditions(const Runner& runner) {
    return {{"raygrade", RAYGRADE_VERSION},
            {"compiler", toolchain_fingerprint(runner.build.compiler)},
            {"sandbox", std::string(to_string(runner.sandbox->tier()))}};
}

std::vector<Difference> differences(const std::vector<Condition>& here, const std::vector<Condition>& there) {
    std::vector<Difference> found;
    for (const Condition& each : here) {
        const Condition* other = find(there, each.what);
        if (other == nullptr || *other != each)
            found.push_back({each.what, each.value, other == nullptr ? "" : other->value});
    }
    for (const Condition& each : there) {
        if (find(here, each.what) == nullptr) found.push_back({each.what, "", each.value});
    }
    return found;
}

nlohmann::ordered_json to_json(const std::vector<Condition>& conditions) {
    auto json = nlohmann::ordered_json::object();
    for (const Condition& each : conditions) json[each.what] = each.value;
    return json;
}

std::vector<Condition> conditions_in(const nlohmann::ordered_json& json) {
    std::vector<Condition> conditions;
    for (const auto& [what, value] : json.get_ref<const nlohmann::ordered_json::object_t&>())
        conditions.push_back({what, value.get<std::string>()});
    return conditions;
}

}  // namespace harness
