#include "harness/record/hard_scenes_sentences.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "harness/mark/score/doubts_text.h"

namespace harness {
namespace {

std::string_view words_of(Loss loss) {
    switch (loss) {
        case Loss::digits: return "fewer right digits than printed";
        case Loss::wrong: return "wrong";
        case Loss::missing: return "not printed";
        case Loss::not_a_number: return "nan or inf";
        case Loss::hit_missed: return "the ray hits, but the program printed no value";
        case Loss::miss_hit: return "the ray misses, but the program printed a value";
        case Loss::other_first: return "wrong first object";
    }
    return "";
}

/// "t: 3 of 8 digits and far root"
std::string name_of(const HardItem& item) {
    const std::string name(name_in_words(item.item));
    std::vector<std::string> details;
    if (item.digits_printed > 0)
        details.push_back(fmt::format("{} of {} digits", item.digits_kept, item.digits_printed));
    if (!item.diagnosis.empty()) details.push_back(item.diagnosis);
    return details.empty() ? name : fmt::format("{}: {}", name, fmt::join(details, " and "));
}

std::string scene_in_words(const HardResult& scene) {
    std::string text;
    if (!scene.ended.empty()) text += scene.ended + " ";
    if (const std::string lost = losses_in_words(scene.items); !lost.empty()) text += lost + ".";
    return text;
}

}  // namespace

std::string losses_in_words(const std::vector<HardItem>& items) {
    constexpr std::array order = {Loss::not_a_number, Loss::hit_missed, Loss::miss_hit, Loss::other_first,
                                  Loss::wrong,        Loss::missing,    Loss::digits};
    std::vector<std::string> groups;
    for (const Loss loss : order) {
        std::vector<std::pair<int, std::string>> names;
        for (const HardItem& item : items) {
            if (item.loss == loss) names.emplace_back(item.question, name_of(item));
        }
        if (!names.empty()) groups.push_back(fmt::format("{}: {}", words_of(loss), items_in_words(names)));
    }
    return fmt::format("{}", fmt::join(groups, "; "));
}

std::vector<std::string> hard_scenes_sentences(const HardScenesReport& report) {
    std::vector<std::string> sentences;
    if (report.tried() == 0) return sentences;
    sentences.push_back(
        fmt::format("The program's own method survives {} of {} hard scenes.", report.survived(), report.tried()));
    for (const HardResult& scene : report.scenes) {
        const std::string lost = scene_in_words(scene);
        if (!scene.skipped.empty() || lost.empty()) continue;
        sentences.push_back(fmt::format("{} ({}), where {}. {}", scene.name, scene.changes, scene.asks, lost));
        if (!scene.advice.empty()) sentences.back() += " " + scene.advice;
    }
    return sentences;
}

std::string hard_scenes_text(const HardScenesReport& report) {
    std::string text = fmt::format("{:<46}{:<28}{}\n", "hard scene", "your program", "advice");
    for (const HardResult& scene : report.scenes) {
        const std::string_view verdict = !scene.skipped.empty() ? "left out"
                                         : !scene.survives()    ? "breaks"
                                         : scene.items.empty()  ? "survives"
                                                                : "survives, with fewer digits";
        const std::string row = fmt::format("{:<46}{:<28}{}", scene.name, verdict, scene.advice);
        text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
        const std::string lost = scene_in_words(scene);
        if (!scene.skipped.empty()) {
            text += fmt::format("    {}\n", scene.skipped);
        } else if (!lost.empty()) {
            text += fmt::format("    {}: {}\n    {}\n", scene.changes, scene.asks, lost);
        }
    }
    return text + fmt::format("\n{} of {} hard scenes survived.\n", report.survived(), report.tried());
}

}  // namespace harness
