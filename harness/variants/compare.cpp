#include "harness/variants/compare.h"

#include <algorithm>

namespace harness::variants {
namespace {

/// The printed text without blanks, because equal answers may differ in them.
std::string without_blanks(const std::string& text) {
    std::string plain;
    for (const char c : text) {
        if (c != ' ' && c != '\t' && c != '\n') plain += c;
    }
    return plain;
}

/// Whether the item has no value if the ray misses.
bool may_be_none(const reference::ItemSpec& spec) {
    return reference::item_of(spec.id).exists != reference::Exists::always;
}

/// Whether a repeated answer is evidence. It is not for the sentence about the first hit, which has few possible
/// values; for "none", which a program prints if its ray never hits; and for 0, which an unset variable may have.
bool is_telling(const ItemScore& item) {
    if (item.spec.shape == reference::Shape::first_object || (may_be_none(item.spec) && !item.error)) return false;
    return item.printed.find_first_of("123456789") != std::string::npos;
}

/// The indices of an item's question and of the item itself in a score.
struct ItemPlace {
    std::size_t question, item;

    const ItemScore& in(const Score& score) const { return score.questions.at(question).items.at(item); }
};

ItemOnVariant finding(const Score& base, const VariantsReport& report, ItemPlace place, std::size_t run) {
    const ItemScore& before = place.in(base);
    const ItemScore& after = place.in(report.runs[run].score);
    const int question = base.questions[place.question].number;
    return {question, std::string(before.spec.name), run, before.printed, after.printed, after.diagnosis};
}

/// Adds the results of one item to the report.
void compare_item(const Score& base, ItemPlace place, VariantsReport& report) {
    const ItemScore& before = place.in(base);
    if (before.verdict != ItemVerdict::right || before.printed.empty()) return;
    const std::string printed = without_blanks(before.printed);
    bool moves = false;
    std::vector<std::size_t> same_and_wrong;
    std::vector<ItemOnVariant> broken;
    for (std::size_t run = 0; run < report.runs.size(); ++run) {
        const ItemScore& after = place.in(report.runs[run].score);
        const bool same = without_blanks(after.printed) == printed;
        moves = moves || !same;
        if (after.verdict == ItemVerdict::right) continue;
        if (same) same_and_wrong.push_back(run);
        // Larger numbers need more digits. A program that prints too few does not compute wrongly.
        const bool fair = after.verdict == ItemVerdict::follow || after.diagnosis == "too few decimals";
        if (!fair) broken.push_back(finding(base, report, place, run));
    }
    if (moves) ++report.moved;
    const std::size_t enough = std::min<std::size_t>(2, report.runs.size() + report.not_tried.size());
    if (!moves && same_and_wrong.size() >= enough && is_telling(before)) {
        report.unmoved.push_back(finding(base, report, place, same_and_wrong.front()));
    } else {
        report.broken.insert(report.broken.end(), broken.begin(), broken.end());
    }
}

VariantsVerdict verdict_of(const VariantsReport& report) {
    if (!report.unmoved.empty()) return VariantsVerdict::does_not_move;
    if (!report.broken.empty()) return VariantsVerdict::breaks;
    return report.moved > 0 ? VariantsVerdict::computes : VariantsVerdict::not_found;
}

}  // namespace

VariantsReport compare(const Score& base, std::vector<VariantRun> runs, std::vector<UntriedVariant> not_tried,
                       std::vector<std::string> not_found) {
    VariantsReport report;
    report.runs = std::move(runs);
    report.not_tried = std::move(not_tried);
    report.not_found = std::move(not_found);
    for (std::size_t q = 0; !report.runs.empty() && q < base.questions.size(); ++q) {
        for (std::size_t i = 0; i < base.questions[q].items.size(); ++i) compare_item(base, {q, i}, report);
    }
    std::ranges::stable_sort(report.broken, {}, &ItemOnVariant::run);
    report.verdict = verdict_of(report);
    for (VariantRun& run : report.runs) {
        if (run.score.max_points > 0) run.share = run.score.points / run.score.max_points;
        run.score = {};
    }
    return report;
}

}  // namespace harness::variants
