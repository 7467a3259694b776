#include "harness/report/accuracy/sentences.h"

#include <fmt/format.h>

#include <algorithm>

#include "harness/text/listed.h"

namespace harness::report {
namespace {

using reference::accuracy::Decision;

std::string value_text(const Decision& decision) {
    const bool is_zero = decision.sign == 0;
    if (decision.what.starts_with("order")) return is_zero ? ": both at the same t exactly" : ": very close";
    return is_zero ? " is exactly 0" : fmt::format(" is {:.3g}", decision.value);
}

}  // namespace

std::string item_name(const reference::accuracy::ItemAccuracy& item) {
    return fmt::format("{} {}", item.spec.question, item.spec.name);
}

std::string decision_sentence(const Decision& decision) {
    std::string text = fmt::format("{}{}. It decides {}.", decision.what, value_text(decision), decision.asks);
    if (decision.sign == 0) {
        text += " One rounding error could change the decision in any precision.";
    } else if (!decision.double_is_sure) {
        text += " Rounding can change this in float and in double.";
    } else if (!decision.float_is_sure) {
        text += " Rounding can change this in float, but not in double.";
    }
    return text + (decision.wrong.empty() ? " Float and double both decide correctly here."
                                          : fmt::format(" Wrong here in {}.", listed(decision.wrong)));
}

std::string decisions_summary(const std::vector<Decision>& decisions) {
    const auto hang = std::count_if(decisions.begin(), decisions.end(),
                                    [](const Decision& decision) { return decision.hangs_on_rounding(); });
    if (hang == 0) return "No hit decision depends on rounding, not even in float.";
    return fmt::format("Rounding can change {} of the {} hit decisions; the others are certain even in float.", hang,
                       decisions.size());
}

std::string wrapped(const std::string& sentence) {
    constexpr std::size_t most = 110;
    std::string text;
    std::string line;
    for (std::size_t at = 0; at < sentence.size();) {
        const std::size_t end = std::min(sentence.find(' ', at), sentence.size());
        const std::string word = sentence.substr(at, end - at);
        if (!line.empty() && line.size() + 1 + word.size() > most) {
            text += line + "\n";
            line = " ";
        }
        line += (line.empty() ? "" : " ") + word;
        at = end + 1;
    }
    return text + line + "\n";
}

}  // namespace harness::report
