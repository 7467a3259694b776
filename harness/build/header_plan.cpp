#include "harness/build/header_plan.h"

#include <algorithm>
#include <map>
#include <utility>

namespace harness {

HeaderPlan plan_headers(const std::vector<HeaderLines>& blocks,
                        const std::function<bool(const HeaderLines&)>& is_kept) {
    constexpr std::size_t fewest_sources = 4;
    std::map<HeaderLines, std::vector<std::size_t>> users;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const HeaderParts parts = header_parts(blocks[i]);
        if (!parts.includes.empty()) users[lines_of(parts)].push_back(i);
    }
    std::erase_if(users,
                  [&](const auto& header) { return header.second.size() < fewest_sources && !is_kept(header.first); });
    std::vector<std::pair<HeaderLines, std::vector<std::size_t>>> most_used(users.begin(), users.end());
    std::stable_sort(most_used.begin(), most_used.end(),
                     [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
    HeaderPlan plan;
    plan.header_of.resize(blocks.size());
    for (const auto& [lines, blocks_of] : most_used) {
        for (const std::size_t block : blocks_of) plan.header_of[block] = plan.headers.size();
        plan.headers.push_back(lines);
    }
    return plan;
}

}  // namespace harness
