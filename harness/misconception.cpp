#include "harness/misconception.h"

#include "harness/mistakes.h"

namespace harness {
namespace {

bool explains(const Misconception& mistake, const MatchedItem& printed, Evidence& evidence, double allowance) {
    Known own = evidence.key;
    for (const auto& [id, target] : evidence.own) own.set(id, target);
    for (const Known* known : {&own, &evidence.key}) {
        if (is_one_of(printed, mistake.compute(*known, evidence.scene), evidence, allowance)) return true;
    }
    return false;
}

}  // namespace

std::span<const Misconception> all_misconceptions() {
    static const std::vector<Misconception> table = [] {
        std::vector<Misconception> all = mistakes::of_camera();
        for (const auto* more : {&mistakes::of_sphere(), &mistakes::of_triangle()}) all.insert(all.end(), more->begin(), more->end());
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
