#include "reference/toml/near_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace reference {
namespace {

/// Longer names are compared by their first letters.
constexpr std::size_t longest = 200;

std::string in_lower_case(std::string_view name) {
    std::string lower(name.substr(0, longest));
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

/// How many letters must be inserted, deleted, changed or swapped with the next letter (optimal string alignment).
std::size_t changes_between(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    std::vector<std::size_t> above, next(row.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        next[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            next[j + 1] = std::min({next[j] + 1, row[j + 1] + 1, row[j] + (a[i] == b[j] ? 0 : 1)});
            const bool exchanged = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
            if (exchanged) next[j + 1] = std::min(next[j + 1], above[j - 1] + 1);
        }
        above = std::exchange(row, next);
    }
    return row.back();
}

std::string listed(const std::vector<std::string>& names, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? last : ", ";
        text += names[i];
    }
    return text;
}

}  // namespace

std::vector<std::string> near_names(std::string_view wanted, const std::vector<std::string>& names) {
    constexpr std::size_t most = 3;
    const std::string lower = in_lower_case(wanted);
    std::vector<std::pair<std::size_t, std::string>> near;
    for (const std::string& name : names) {
        const std::string other = in_lower_case(name);
        const std::size_t changes = changes_between(lower, other);
        const bool is_part = lower.size() > 1 && other.find(lower) != std::string::npos;
        if (is_part || changes <= std::max<std::size_t>(1, lower.size() / 3)) near.emplace_back(changes, name);
    }
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    near.resize(std::min(most, near.size()));
    std::vector<std::string> result;
    for (auto& [changes, name] : near) result.push_back(std::move(name));
    return result;
}

std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names) {
    constexpr std::size_t enough = 30;
    if (const auto near = near_names(wanted, names); !near.empty()) {
        return fmt::format("did you mean {}?", listed(near, " or "));
    }
    if (names.empty()) return "there are none";
    const std::vector<std::string> first(names.begin(),
                                         names.begin() + static_cast<std::ptrdiff_t>(std::min(enough, names.size())));
    return fmt::format("there are {}{}", listed(first, ", "),
                       names.size() > enough ? fmt::format(" and {} more", names.size() - enough) : "");
}

}  // namespace reference
