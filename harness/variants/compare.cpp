#include "harness/variants/compare.h"

#include <algorithm>

namespace harness::variants {
namespace {

/// The printed text without blanks, which may differ between equal answers.
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

/// Whether printing the same again says something. It does not for the sentence about the first hit, which has few
/// possible values; for "none", which a program prints if its ray never hits; and for 0, which an unset variable may
/// hold.
bool is_telling(const ItemScore& item) {
    if (item.spec.shape == reference::Shape::first_object || (may_be_none(item.spec) && !item.error)) return false;
    return item.printed.find_first_of("123456789") != std::string::npos;
}

class Comparison {
  public:
    Comparison(const Score& base, VariantsReport& report) : base_(base), report_(report) {}

    void compare() {
        for (std::size_t q = 0; q < base_.questions.size(); ++q) {
            for (std::size_t i = 0; i < base_.questions[q].items.size(); ++i) compare_item(q, i);
        }
        std::stable_sort(report_.broken.begin(), report_.broken.end(),
                         [](const ItemOnVariant& a, const ItemOnVariant& b) { return a.run < b.run; });
    }

  private:
    const ItemScore& item_of(const Score& score, std::size_t q, std::size_t i) const {
        return score.questions.at(q).items.at(i);
    }

    ItemOnVariant finding(std::size_t q, std::size_t i, std::size_t run) const {
        const ItemScore& before = item_of(base_, q, i);
        const ItemScore& after = item_of(report_.runs[run].score, q, i);
        return {base_.questions[q].number,
                std::string(before.spec.name),
                run,
                before.printed,
                after.printed,
                after.diagnosis};
    }

    void compare_item(std::size_t q, std::size_t i) {
        const ItemScore& before = item_of(base_, q, i);
        if (before.verdict != ItemVerdict::right || before.printed.empty()) return;
        const std::string printed = without_blanks(before.printed);
        bool moves = false;
        std::vector<std::size_t> same_and_wrong;
        std::vector<ItemOnVariant> broken;
        for (std::size_t run = 0; run < report_.runs.size(); ++run) {
            const ItemScore& after = item_of(report_.runs[run].score, q, i);
            const bool same = without_blanks(after.printed) == printed;
            moves = moves || !same;
            if (same && after.verdict != ItemVerdict::right) same_and_wrong.push_back(run);
            // Larger numbers need more digits. That is not an error of the computation.
            const bool fair = after.verdict == ItemVerdict::follow || after.diagnosis == "too few decimals";
            if (after.verdict != ItemVerdict::right && !fair) broken.push_back(finding(q, i, run));
        }
        if (moves) ++report_.moved;
        const std::size_t enough = std::min<std::size_t>(2, report_.runs.size() + report_.not_tried.size());
        const bool unmoved = !moves && same_and_wrong.size() >= enough && is_telling(before);
        if (unmoved) {
            report_.unmoved.push_back(finding(q, i, same_and_wrong.front()));
        } else {
            report_.broken.insert(report_.broken.end(), broken.begin(), broken.end());
        }
    }

    const Score& base_;
    VariantsReport& report_;
};

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
    if (!report.runs.empty()) Comparison(base, report).compare();
    report.verdict = verdict_of(report);
    for (VariantRun& run : report.runs) {
        if (run.score.max_points > 0) run.share = run.score.points / run.score.max_points;
        run.score = {};
    }
    return report;
}

}  // namespace harness::variants
