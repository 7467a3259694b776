#include "harness/build/header_plan.h"

#include <algorithm>
#include <map>

namespace harness {

HeaderPlan plan_headers(const std::vector<HeaderLines>& wanted,
                        const std::function<bool(const HeaderLines&)>& is_kept) {
    constexpr std::size_t fewest_sources = 4;
    std::map<HeaderLines, std::vector<std::size_t>> users;
    for (std::size_t i = 0; i < wanted.size(); ++i) users[wanted[i]].push_back(i);
    HeaderPlan plan;
    for (const auto& [lines, sources] : users) {
        if (!lines.empty() && (sources.size() >= fewest_sources || is_kept(lines))) {
            plan.headers.push_back({lines, sources});
        } else {
            plan.without_one.insert(plan.without_one.end(), sources.begin(), sources.end());
        }
    }
    std::ranges::stable_sort(plan.headers, std::ranges::greater(),
                             [](const auto& header) { return header.sources.size(); });
    return plan;
}

}  // namespace harness
