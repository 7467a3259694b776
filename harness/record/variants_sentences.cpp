#include "harness/record/variants_sentences.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace harness {
namespace {

template <class Items>
std::string names_of(const Items& items) {
    std::vector<std::pair<int, std::string>> names;
    for (const auto& item : items) names.emplace_back(item.question, item.item);
    return items_in_words(names);
}

std::string plural(std::size_t count, std::string_view one) {
    return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

/// The broken items of a run, each with its mistake if known.
std::string broken_on(const VariantsReport& report, std::size_t run) {
    std::vector<std::pair<int, std::string>> names;
    for (const ItemOnVariant& item : report.broken) {
        if (item.run != run) continue;
        const std::string why = item.after.empty() ? "not printed" : item.diagnosis;
        names.emplace_back(item.question,
                           fmt::format("{}{}{}", name_in_words(item.item), why.empty() ? "" : ": ", why));
    }
    return items_in_words(names);
}

/// "any of 4 other scenes", "2 of 4 other scenes (triangle in front; ray beside the sphere)"
std::string which(const std::vector<std::string_view>& names, std::size_t all) {
    if (all == 1) return "another scene";
    if (names.size() == all) return fmt::format("any of {} other scenes", all);
    const bool named = std::none_of(names.begin(), names.end(), [](std::string_view name) { return name.empty(); });
    return fmt::format("{} of {} other scenes{}", names.size(), all,
                       named ? fmt::format(" ({})", fmt::join(names, "; ")) : "");
}

}  // namespace

std::string unmoved_evidence(const VariantsReport& report) {
    // A number with decimals is better evidence than a 0.
    const auto telling = [](const ItemOnVariant& item) { return item.before.find('.') != std::string::npos; };
    auto shown = std::find_if(report.unmoved.begin(), report.unmoved.end(), telling);
    if (shown == report.unmoved.end()) shown = report.unmoved.begin();
    const VariantRun& run = report.runs.at(shown->run);
    std::string text =
        fmt::format("Question {}, {}: the program prints {} with {}, and {} with {} in its source.", shown->question,
                    name_in_words(shown->item), shown->before, run.before, shown->after, run.changes);
    std::vector<ItemOnVariant> others;
    std::copy_if(report.unmoved.begin(), report.unmoved.end(), std::back_inserter(others),
                 [&](const ItemOnVariant& item) { return &item != &*shown; });
    if (!others.empty()) text += fmt::format(" The same is true of {}.", names_of(others));
    if (report.moved == 0) return text + " No other answer changes.";
    return text + fmt::format(" {} changed.", plural(static_cast<std::size_t>(report.moved), "right answer"));
}

std::vector<std::string> not_tried_sentences(const VariantsReport& report) {
    std::map<std::string_view, std::vector<std::string_view>> names_by_reason;
    for (const UntriedVariant& scene : report.not_tried) names_by_reason[scene.why].push_back(scene.name);
    std::vector<std::string> sentences;
    for (const auto& [why, names] : names_by_reason) {
        sentences.push_back(fmt::format("The program could not be run on {}: {}.",
                                        which(names, report.runs.size() + report.not_tried.size()), why));
    }
    return sentences;
}

std::vector<std::string> variants_sentences(const VariantsReport& report, Audience audience) {
    if (report.runs.empty()) return not_tried_sentences(report);
    std::vector<std::string> sentences;
    sentences.push_back(fmt::format(
        "The program was also run on {}{}.", plural(report.runs.size(), "other scene"),
        report.not_found.empty()
            ? ""
            : fmt::format(" (not found in its source, so not changed: {})", fmt::join(report.not_found, ", "))));
    if (report.verdict == VariantsVerdict::computes) sentences.emplace_back("Every right answer is right there too.");
    if (!report.unmoved.empty() && audience == Audience::instructor) {
        sentences.push_back(fmt::format("The printed numbers of {} do not change with the scene in the source.",
                                        names_of(report.unmoved)));
    }
    for (std::size_t run = 0; run < report.runs.size(); ++run) {
        const std::string broken = broken_on(report, run);
        if (broken.empty()) continue;
        sentences.push_back(fmt::format("With {} ({}), these are no longer right: {}.", report.runs[run].changes,
                                        report.runs[run].name, broken));
    }
    for (std::string& sentence : not_tried_sentences(report)) sentences.push_back(std::move(sentence));
    return sentences;
}

}  // namespace harness
