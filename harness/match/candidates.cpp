#include "harness/match/candidates.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "harness/match/label.h"

namespace harness {
namespace {

using reference::ItemSpec;
using reference::Shape;

std::vector<ItemSpec> scalars_of(std::span<const ItemSpec> items) {
    std::vector<ItemSpec> scalars;
    std::copy_if(items.begin(), items.end(), std::back_inserter(scalars),
                 [](const ItemSpec& i) { return i.shape == Shape::scalar; });
    return scalars;
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
    std::vector<Candidate> result;
    for (Candidate& candidate : gather_rows(values, items)) {
        const PrintedValue& value = candidate.value;
        const std::string& names = value.label.empty() ? value.above : value.label;
        const std::vector<std::size_t> listed =
            value.groups == 1 ? listed_items(names, scalars) : std::vector<std::size_t>();
        if (listed.size() >= 2 && listed.size() == value.numbers.size()) {
            std::vector<ItemSpec> named;
            for (const std::size_t i : listed) named.push_back(scalars[i]);
            for (Candidate& part : take_apart(candidate, named, 0)) result.push_back(std::move(part));
        } else {
            result.push_back(std::move(candidate));
        }
    }
    return result;
}

}  // namespace harness
