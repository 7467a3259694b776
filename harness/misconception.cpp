#include "harness/misconception.h"

#include "harness/mistakes.h"

namespace harness {
namespace {

Known with_own(const Evidence& evidence, Digits digits) {
    Known known = evidence.key;
    for (const auto& [id, target] : evidence.own_values(digits)) known.set(id, target);
    return known;
}

bool explains(const Misconception& mistake, const MatchedItem& printed, Evidence& evidence, double allowance) {
    for (const Known& known :
         {with_own(evidence, Digits::of_stream), with_own(evidence, Digits::as_printed), evidence.key}) {
        if (is_one_of(printed, mistake.compute(known, evidence.scene), evidence, allowance)) return true;
    }
    return false;
}

}  // namespace

std::span<const Misconception> all_misconceptions() {
    static const std::vector<Misconception> table = [] {
        std::vector<Misconception> all = mistakes::of_camera();
        for (const auto* more : {&mistakes::of_sphere(), &mistakes::of_triangle()})
            all.insert(all.end(), more->begin(), more->end());
        return all;
    }();
    return table;
}

const Misconception* find_misconception(const MatchedItem& printed, Evidence& evidence, double allowance) {
    for (const Misconception& mistake : all_misconceptions()) {
        const bool about_item = mistake.item == ItemId{printed.spec.question, printed.spec.name};
        if (about_item && explains(mistake, printed, evidence, allowance)) return &mistake;
    }
    return nullptr;
}

}  // namespace harness
