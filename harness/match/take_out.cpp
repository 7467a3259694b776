#include "harness/match/take_out.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "harness/match/candidates.h"

namespace harness {
namespace {

bool is_same_number(const PrintedNumber& a, const PrintedNumber& b) {
    return a.value == b.value || (std::isnan(a.value) && std::isnan(b.value));
}

/// A number of a value in the transcript: the value's place among those on the lines, and the number's in it.
using NumberOfValue = std::pair<std::size_t, std::size_t>;

/// For each number of the lines the value that has it; empty if none has. Both are in the same order, forwards or
/// backwards, but values don't have all numbers.
template <class Number, class Part>
std::vector<std::optional<NumberOfValue>> align(Number number, Number last_number, Part part, Part last_part,
                                                const std::vector<PrintedValue>& values) {
    std::vector<std::optional<NumberOfValue>> aligned;
    for (; number != last_number; ++number) {
        const bool is_next = part != last_part && is_same_number(*number, values[part->first].numbers[part->second]);
        aligned.push_back(is_next ? std::optional(*part++) : std::nullopt);
    }
    return aligned;
}

/// Which numbers of the values were read. Equal ones can't be told apart where an earlier
/// place took some of them; then any will do.
std::set<NumberOfValue> numbers_of_values(const TakenNumbers& read, const std::vector<PrintedValue>& values) {
    std::vector<NumberOfValue> parts;
    for (std::size_t v = 0; v < values.size(); ++v) {
        for (std::size_t i = 0; i < values[v].numbers.size(); ++i) parts.emplace_back(v, i);
    }
    const auto forwards = align(read.numbers.begin(), read.numbers.end(), parts.begin(), parts.end(), values);
    const auto backwards = align(read.numbers.rbegin(), read.numbers.rend(), parts.rbegin(), parts.rend(), values);
    std::set<NumberOfValue> found;
    for (const std::size_t i : read.read) {
        const auto& part = forwards[i] ? forwards[i] : backwards[read.numbers.size() - 1 - i];
        if (part) found.insert(*part);
    }
    return found;
}

/// A list with a name for each of its numbers, as in "a, b, c: 1 2 3", as its numbers; any other value as it is.
std::vector<PrintedValue> named_numbers(const PrintedValue& value, std::span<const reference::ItemSpec> items) {
    std::vector<PrintedValue> numbers;
    for (Candidate& candidate : candidates_of({value}, items)) numbers.push_back(std::move(candidate.value));
    return numbers.size() == value.numbers.size() ? numbers : std::vector{value};
}

/// What remains of a value without these of its numbers.
std::vector<PrintedValue> without_numbers(const PrintedValue& value, const std::vector<std::size_t>& taken,
                                          std::span<const reference::ItemSpec> items) {
    std::vector<PrintedValue> rest = named_numbers(value, items);
    for (auto i = taken.rbegin(); i != taken.rend(); ++i) {
        if (rest.size() > 1) {
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(*i));
            continue;
        }
        rest.front().numbers.erase(rest.front().numbers.begin() + static_cast<std::ptrdiff_t>(*i));
        rest.front().groups = 1;
        rest.front().bar_after = 0;
    }
    return rest;
}

}  // namespace

void take_out(Transcript& transcript, const ValuesAt& there, const TakenNumbers& read,
              std::span<const reference::ItemSpec> items) {
    std::map<std::size_t, std::vector<std::size_t>, std::greater<>> taken;  // the last value first
    for (const auto& [value, index] : numbers_of_values(read, there.values)) taken[value].push_back(index);
    for (const auto& [value, indices] : taken) {
        const auto [section, index] = there.from[value];
        auto& values = transcript.sections[section].values;
        const auto at = values.erase(values.begin() + static_cast<std::ptrdiff_t>(index));
        if (indices.size() == there.values[value].numbers.size()) continue;
        const auto rest = without_numbers(there.values[value], indices, items);
        values.insert(at, rest.begin(), rest.end());
    }
}

}  // namespace harness
