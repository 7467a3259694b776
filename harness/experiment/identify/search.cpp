#include "harness/experiment/identify/search.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace harness::experiment {

using reference::ItemSpec;
using reference::Shape;

/// Calls `then` for each block of free numbers of the item's shape. If a number has the item's name, numbers without
/// the name do not count.
template <class Then>
void Search::for_each_candidate(const ItemSpec& item, std::span<const Pattern> patterns, Then then) {
    const std::size_t size = size_of(item.shape), side = side_of(item.shape);
    const bool needs_name = side == 1 && words_.is_named_somewhere(item);
    for (std::size_t first = 0; first < slots_.size(); ++first) {
        if (claims_.is_used(first) || (needs_name && words_.fit(first, item) < LabelFit::named)) continue;
        for (const auto& [step, row] : patterns) {
            Candidate candidate;
            for (std::size_t i = 0; i < size; ++i) {
                const std::size_t slot =
                    item.shape == Shape::vector ? first + i * step : first + i / side * row + i % side * step;
                if (slot >= slots_.size() || claims_.is_used(slot)) break;
                candidate.slots.push_back(slot);
            }
            if (candidate.slots.size() < size) continue;
            if (words_.has_only_dashes(candidate)) then(candidate);
            candidate.takes_signs = words_.has_signs_apart(candidate);
            if (candidate.takes_signs) then(candidate);
        }
    }
}

void Search::find_right(const ItemSpec& item) {
    using Rank = std::tuple<int, int, int, std::size_t>;
    std::optional<std::pair<Rank, Candidate>> best;
    for_each_candidate(item, all_patterns(item.shape), [&](Candidate& candidate) {
        if (!claims_.moves(candidate) || !claims_.is_right(item, candidate)) return;
        if (side_of(item.shape) > 1) candidate.order = words_.stated_order(candidate.slots, item);
        if (candidate.order != MatrixOrder::unsaid && !claims_.is_right(item, candidate)) return;
        const bool is_far = words_.distance_from_question(candidate.slots, item) > 1;
        if (words_.is_barred(candidate, item) || (is_far && !has_headings_inside(candidate))) return;
        const std::size_t first = candidate.slots.front();
        const int lines = slots_[candidate.slots.back()].place.line - slots_[first].place.line;
        const int namelessness = words_.fit(first, item) >= LabelFit::weak ? 0 : 1;
        const Rank rank{words_.distance_from_question(candidate.slots, item), namelessness, lines, first};
        if (!best || rank < best->first) best = {rank, candidate};
    });
    if (!best) return;
    if (has_headings_inside(best->second)) words_.forget_headings();
    claims_.add(item, std::move(best->second), Evidence::right);
}

/// Whether a matrix continues after another heading, which is then not a heading.
bool Search::has_headings_inside(const Candidate& candidate) const {
    constexpr std::size_t of_matrix = 9;
    return candidate.slots.size() >= of_matrix && std::ranges::any_of(candidate.slots, [&](std::size_t slot) {
               return slots_[slot].question != slots_[candidate.slots.front()].question;
           });
}

void Search::find_derived(const ItemSpec& item) {
    std::vector<Candidate> candidates;
    if (const MatchedItem* read = words_.value_of(item.id)) {
        auto slots = words_.slots_of(*read->value);
        if (slots.size() == size_of(item.shape) && !claims_.is_used(slots))
            candidates.push_back({std::move(slots), read->order});
    }
    for_each_candidate(item, common_patterns(item.shape), [&](Candidate& candidate) {
        if (words_.distance_from_question(candidate.slots, item) > 1) return;
        if (side_of(item.shape) > 1) candidate.order = words_.stated_order(candidate.slots, item);
        candidates.push_back(candidate);
    });
    constexpr std::size_t most = 120;
    if (candidates.size() > most) candidates.resize(most);
    std::optional<std::pair<Evidence, Candidate>> best;
    for (Candidate& candidate : candidates) {
        if (!claims_.moves(candidate) || words_.is_barred(candidate, item)) continue;
        const auto evidence = claims_.evidence_of(item, candidate);
        if (evidence && (!best || *evidence < best->first)) best = {*evidence, std::move(candidate)};
    }
    if (best) claims_.add(item, std::move(best->second), best->first);
}

void Search::find_rest(const ItemSpec& item) {
    if (side_of(item.shape) > 1 || !words_.has_heading(item.question)) return;
    Candidate rest;
    const auto [first, last] = extent_of(item);
    for (std::size_t slot = first; slot < last; ++slot) {
        if (!claims_.is_used(slot) && !words_.is_no_answer(slot, item)) rest.slots.push_back(slot);
    }
    if (rest.slots.size() != size_of(item.shape) || !claims_.moves(rest)) return;
    rest.takes_signs = !words_.has_only_dashes(rest);
    claims_.add(item, std::move(rest), Evidence::rest);
}

void Search::find_constant(const ItemSpec& item) {
    const std::vector<std::size_t> all = constants_of(item);
    std::vector<std::size_t> near;
    for (const std::size_t slot : all) {
        if (is_beside_neighbor(slot, item)) near.push_back(slot);
    }
    if (near.size() == 1) return claims_.add(item, {near}, Evidence::right);
    if (all.size() == 1 && !is_left_for(item)) claims_.add(item, {all}, Evidence::right);
}

bool Search::is_left_for(const ItemSpec& item) {
    const MatchedItem* read = words_.value_of(item.id);
    const auto own = read != nullptr ? words_.slots_of(*read->value) : std::vector<std::size_t>();
    std::size_t count = 0, moving = 0;
    for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
        if (claims_.is_used(slot) || std::ranges::count(own, slot) > 0) continue;
        if (words_.distance_from_question({slot}, item) > 1 || words_.is_no_answer(slot, item)) continue;
        ++count;
        moving += slots_[slot].moves() ? 1 : 0;
    }
    return moving > 0 && (item.shape == Shape::scalar || count >= size_of(item.shape));
}

bool Search::may_be_constant(const ItemSpec& item) {
    return item.shape == Shape::scalar && !constants_of(item).empty();
}

/// The free numbers that are right for a scalar on every scene and do not change.
std::vector<std::size_t> Search::constants_of(const ItemSpec& item) {
    std::vector<std::size_t> constants;
    const auto [first, last] = extent_of(item);
    for (std::size_t slot = first; slot < last; ++slot) {
        if (claims_.is_used(slot) || slots_[slot].moves() || words_.is_barred(slot, item)) continue;
        if (claims_.is_right(item, {{slot}})) constants.push_back(slot);
    }
    return constants;
}

/// The numbers among which the item may be: below the heading of its question, or else between the items of the
/// questions before and after.
std::pair<std::size_t, std::size_t> Search::extent_of(const ItemSpec& item) const {
    std::size_t first = 0, last = slots_.size();
    if (words_.has_heading(item.question)) {
        const auto is_own = [&](const Slot& slot) { return slot.question == item.question; };
        const auto begin = std::ranges::find_if(slots_, is_own);
        const auto end = std::find_if_not(begin, slots_.end(), is_own);
        return {static_cast<std::size_t>(begin - slots_.begin()), static_cast<std::size_t>(end - slots_.begin())};
    }
    for (const ItemSpec& other : items_) {
        const Claim* claim = claims_.of(other.id);
        if (claim == nullptr) continue;
        const auto [least, most] = std::ranges::minmax(claim->candidate.slots);
        if (other.question < item.question) first = std::max(first, most + 1);
        if (other.question > item.question) last = std::min(last, least);
    }
    return {first, std::max(first, last)};
}

/// Whether the slot is next to the slot of a neighboring item.
bool Search::is_beside_neighbor(std::size_t slot, const ItemSpec& item) const {
    for (std::size_t i = 0; i < items_.size(); ++i) {
        const bool is_neighbor =
            (i + 1 < items_.size() && items_[i + 1].id == item.id) || (i > 0 && items_[i - 1].id == item.id);
        const Claim* claim = claims_.of(items_[i].id);
        if (!is_neighbor || items_[i].question != item.question || claim == nullptr) continue;
        const auto [least, most] = std::ranges::minmax(claim->candidate.slots);
        if (slot + 1 == least || slot == most + 1) return true;
    }
    return false;
}

}  // namespace harness::experiment
