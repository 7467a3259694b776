#include "harness/match/candidates.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>

#include "harness/match/label.h"

namespace harness {
namespace {

using reference::ItemSpec;
using reference::Shape;

/// Splits the axes of the camera, printed as one 3 x 3 block, into one axis per group.
std::vector<Candidate> split_groups(const Candidate& list) {
    const PrintedValue& value = list.value;
    std::vector<Candidate> parts;
    const std::size_t size = value.numbers.size() / static_cast<std::size_t>(value.groups);
    for (std::size_t k = 0; k < static_cast<std::size_t>(value.groups); ++k) {
        Candidate part{value, MatrixOrder::unsaid, list.part, list.first, list.count};
        part.value.groups = 1;
        const auto begin = value.numbers.begin() + static_cast<std::ptrdiff_t>(k * size);
        part.value.numbers.assign(begin, begin + static_cast<std::ptrdiff_t>(size));
        part.value.label.clear();
        part.value.above.clear();
        parts.push_back(std::move(part));
    }
    return parts;
}

/// "(w, u, v) = (0.5, 0.25, 0.25)" without w = 1 - u - v, which nobody asks for.
PrintedValue without_w(PrintedValue value) {
    static const RE2 first(R"((?i)(?:barycentric\w*(?:\s+coord\w*)?)?\W*(?:w|alpha)\W+((?:u|beta)\W+(?:v|gamma)\W*))");
    static const RE2 last(R"((?i)(?:barycentric\w*(?:\s+coord\w*)?)?\W*(u\W+v)\W+w\W*)");
    if (value.numbers.size() != 3 || value.groups != 1) return value;
    std::string names;
    if (RE2::FullMatch(value.label, first, &names)) {
        value.numbers.erase(value.numbers.begin());
    } else if (RE2::FullMatch(value.label, last, &names)) {
        value.numbers.pop_back();
    } else {
        return value;
    }
    value.label = names;
    return value;
}

/// The name of what may be an axis: "v" of "v (up)", "right" of "right vector". Empty for what is no vector.
std::string axis_name(const PrintedValue& value) {
    constexpr std::string_view directions[] = {"right", "up", "back", "backward", "backwards"};
    if (value.numbers.size() < 3) return "";
    std::string name = bare_name(value.label);
    const bool has_direction =
        !name.empty() && std::ranges::find(directions, std::string_view(name).substr(1)) != std::end(directions);
    return has_direction ? name.substr(0, 1) : name;
}

/// Names axes that stand one behind the other under names that may be another item's alone, such as V's "v" and
/// "vector", by what they are.
std::vector<PrintedValue> with_axes_named(std::vector<PrintedValue> values, std::span<const ItemSpec> items) {
    using Axes = std::array<std::string_view, 3>;
    static constexpr Axes names[] = {
        {"u", "v", "w"},
        {"u", "v", "n"},
        {"r", "u", "b"},
        {"r", "u", "f"},
        {"s", "u", "f"},
        {"s", "u", "b"},
        {"right", "up", "back"},
        {"right", "up", "backward"},
        {"right", "up", "backwards"},
        {"e0", "e1", "e2"},
        {"basis0", "basis1", "basis2"},
        {"basis1", "basis2", "basis3"},
    };
    if (std::ranges::find(items, reference::item::X_vcs, &ItemSpec::id) == items.end()) return values;
    std::vector<std::string> called;
    for (const PrintedValue& value : values) called.push_back(axis_name(value));
    for (std::size_t i = 0; i + 2 < values.size(); ++i) {
        const bool are_axes = std::ranges::any_of(names, [&](const Axes& axes) {
            return called[i] == axes[0] && called[i + 1] == axes[1] && called[i + 2] == axes[2];
        });
        if (!are_axes) continue;
        for (std::size_t k = 0; k < 3; ++k) values[i + k].label = std::string(1, "xyz"[k]) + " axis";
    }
    return values;
}

/// Whether a label gives one number to two items: "u = v", "u and v".
bool are_equal(std::string_view label) {
    static const RE2 pattern(R"((?i)\W*\w+\s*(?:=|,|&|and|und|et|y)\s*\w+\W*)");
    return RE2::FullMatch(re2::StringPiece(label.data(), label.size()), pattern);
}

std::vector<ItemSpec> scalars_of(std::span<const ItemSpec> items) {
    std::vector<ItemSpec> scalars;
    std::copy_if(items.begin(), items.end(), std::back_inserter(scalars),
                 [](const ItemSpec& i) { return i.shape == Shape::scalar; });
    return scalars;
}

/// Of three barycentric coordinates alpha, beta and gamma one behind the other, says that alpha is no answer: it is
/// 1 - u - v.
std::vector<PrintedValue> without_alpha(std::vector<PrintedValue> values, std::span<const ItemSpec> items) {
    if (std::ranges::find(items, reference::item::triangle::u, &ItemSpec::id) == items.end()) return values;
    static const RE2 alpha(R"((?i)(?:.*\W)?alpha)"), beta(R"((?i)(?:.*\W)?beta)"), gamma(R"((?i)(?:.*\W)?gamma)");
    for (std::size_t i = 0; i + 2 < values.size(); ++i) {
        const auto is = [&](std::size_t k, const RE2& name) {
            return values[i + k].numbers.size() == 1 && RE2::FullMatch(values[i + k].label, name);
        };
        if (is(0, alpha) && is(1, beta) && is(2, gamma)) values[i].label = "intermediate: " + values[i].label;
    }
    return values;
}

}  // namespace

std::vector<Candidate> take_apart(const Candidate& list, std::span<const ItemSpec> items, std::size_t first) {
    const PrintedValue& value = list.value;
    std::vector<Candidate> parts;
    for (std::size_t k = 0; k < value.numbers.size(); ++k) {
        Candidate part{value,      MatrixOrder::unsaid, list.part,
                       list.first, list.count,          static_cast<int>(value.numbers.size())};
        part.value.numbers = {value.numbers[k]};
        part.value.groups = 1;
        part.value.label = std::string(items[first + k].name);
        part.value.above.clear();
        parts.push_back(std::move(part));
    }
    return parts;
}

std::vector<Candidate> candidates_of(const std::vector<PrintedValue>& values, std::span<const ItemSpec> items) {
    const std::vector<ItemSpec> scalars = scalars_of(items);
    const auto vectors = static_cast<std::size_t>(
        std::count_if(items.begin(), items.end(), [](const ItemSpec& i) { return i.shape == Shape::vector; }));
    std::vector<Candidate> result;
    for (Candidate& candidate : gather_rows(with_axes_named(without_alpha(values, items), items), items)) {
        if (!scalars.empty()) candidate.value = without_w(std::move(candidate.value));
        const PrintedValue& value = candidate.value;
        const std::string& names = value.label.empty() ? value.above : value.label;
        const std::vector<std::size_t> listed =
            value.groups == 1 ? listed_items(names, scalars) : std::vector<std::size_t>();
        if (listed.size() >= 2 && listed.size() == value.numbers.size()) {
            std::vector<ItemSpec> named;
            for (const std::size_t i : listed) named.push_back(scalars[i]);
            for (Candidate& part : take_apart(candidate, named, 0)) result.push_back(std::move(part));
        } else if (value.numbers.size() == 1 && listed.size() == 2 && are_equal(names)) {
            for (const std::size_t i : listed) {
                result.push_back(candidate);
                result.back().value.label = std::string(scalars[i].name);
            }
        } else if (matrix_size(items) == 0 && vectors >= 2 && value.groups == static_cast<int>(vectors)) {
            for (Candidate& part : split_groups(candidate)) result.push_back(std::move(part));
        } else {
            result.push_back(std::move(candidate));
        }
    }
    return result;
}

}  // namespace harness
