#include "harness/prepare/check_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "harness/report/accuracy/sentences.h"

namespace harness::prepare {
namespace {

/// "4.t" for each item that a question asks for.
std::map<ItemId, std::string> asked_names(const reference::AnswerKey& key) {
    std::map<ItemId, std::string> names;
    for (const reference::KeyQuestion& question : key.questions) {
        for (const reference::KeyItem& item : question.items)
            names[item.spec.id] = fmt::format("{}.{}", question.number, item.spec.name);
    }
    return names;
}

std::string quoted(const std::vector<NamedMistake>& mistakes) {
    std::vector<std::string> names;
    for (const NamedMistake& mistake : mistakes) names.push_back(fmt::format("\"{}\"", mistake.name));
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Whether a question asks for an item of this kind of object.
bool is_asked_about(const reference::AnswerKey& key, reference::Subject kind) {
    return std::ranges::any_of(key.questions, [&](const reference::KeyQuestion& question) {
        return std::ranges::any_of(question.items,
                                   [&](const reference::KeyItem& item) { return item.spec.id.subject == kind; });
    });
}

}  // namespace

std::string objects_text(const reference::AnswerKey& key) {
    std::vector<std::string> met;
    std::string not_asked;
    for (const auto& [kind, decision] : key.decisions.objects) {
        met.push_back(fmt::format("{} {}", to_string(kind), decision));
        if (is_asked_about(key, kind)) continue;
        not_asked += fmt::format("No question asks about the {}. It can only be the first object.\n", to_string(kind));
    }
    if (met.empty()) return "";
    return fmt::format("Along the ray: {}. First object: {}.\n{}", fmt::join(met, ", "), key.decisions.first,
                       not_asked);
}

std::string mistakes_text(const ShownMistakes& mistakes, const reference::AnswerKey& key) {
    const std::map<ItemId, std::string> names = asked_names(key);
    std::string text =
        fmt::format("This scene reveals {} of {} named mistakes; {} of them give a unique answer.\n",
                    mistakes.shown.size(), mistakes.shown.size() + mistakes.hidden.size(), mistakes.told_apart());
    std::map<std::string, std::vector<NamedMistake>> hidden;
    for (const NamedMistake& mistake : mistakes.hidden) hidden[names.at(mistake.item)].push_back(mistake);
    if (!hidden.empty()) text += "Mistakes that this scene may not reveal:\n";
    for (const auto& [name, list] : hidden) text += fmt::format("  {:<16} {}", name, report::wrapped(quoted(list)));
    if (!mistakes.alike.empty()) text += "Mistakes that give the same answer:\n";
    for (const auto& group : mistakes.alike)
        text += fmt::format("  {:<16} {}", names.at(group.front().item), report::wrapped(quoted(group)));
    return text;
}

std::string decisions_text(const std::vector<reference::accuracy::Decision>& decisions) {
    std::string text;
    for (const reference::accuracy::Decision& decision : decisions) {
        if (decision.hangs_on_rounding())
            text += fmt::format("  {}", report::wrapped(report::decision_sentence(decision)));
    }
    return text;
}

std::string proposal_text(const Proposal& proposal) {
    const ShownMistakes& before = proposal.before;
    if (proposal.changes.empty()) return "Found no better scene. Try more --steps or another --seed.\n";
    std::string text = fmt::format("{:<28} {:>8} {:>8}\n", "", "before", "proposed");
    const auto row = [&](std::string_view what, std::size_t was, std::size_t is) {
        text += fmt::format("{:<28} {:>8} {:>8}\n", what, was, is);
    };
    row("mistakes revealed", before.shown.size(), proposal.mistakes.shown.size());
    row("mistakes not revealed", before.hidden.size(), proposal.mistakes.hidden.size());
    row("with a unique answer", before.told_apart(), proposal.mistakes.told_apart());
    text += "changes:\n";
    for (const std::string& change : proposal.changes) text += fmt::format("  {}\n", change);
    return text;
}

}  // namespace harness::prepare
