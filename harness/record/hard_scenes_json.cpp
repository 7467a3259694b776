#include "harness/record/hard_scenes_json.h"

#include <stdexcept>

namespace harness {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// to_string is empty for every number beyond the last loss.
Loss loss_called(const std::string& word) {
    for (int i = 0; !to_string(static_cast<Loss>(i)).empty(); ++i) {
        if (to_string(static_cast<Loss>(i)) == word) return static_cast<Loss>(i);
    }
    throw std::invalid_argument(word);
}

ordered_json or_null(const std::string& text) {
    return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

std::string text_of(const json& value) {
    return value.is_null() ? "" : value.get<std::string>();
}

std::string_view verdict_of(const HardResult& scene) {
    if (!scene.skipped.empty()) return "skipped";
    return scene.survives() ? "survives" : "breaks";
}

ordered_json item_json(const HardItem& item) {
    const auto count = [&](int digits) {
        return item.digits_printed == 0 ? ordered_json(nullptr) : ordered_json(digits);
    };
    return {{"question", item.question},
            {"item", item.item},
            {"loss", to_string(item.loss)},
            {"digits_kept", count(item.digits_kept)},
            {"digits_printed", count(item.digits_printed)},
            {"diagnosis", or_null(item.diagnosis)}};
}

HardItem item_from(const json& record) {
    const auto count = [](const json& digits) { return digits.is_null() ? 0 : whole_number<int>(digits); };
    return {whole_number<int>(record.at("question")), record.at("item").get<std::string>(),
            loss_called(record.at("loss")),           count(record.at("digits_kept")),
            count(record.at("digits_printed")),       text_of(record.at("diagnosis"))};
}

}  // namespace

ordered_json hard_scenes_json(const HardScenesReport& report) {
    ordered_json scenes = ordered_json::array();
    for (const HardResult& scene : report.scenes) {
        ordered_json items = ordered_json::array();
        for (const HardItem& item : scene.items) items.push_back(item_json(item));
        scenes.push_back({{"name", scene.name},
                          {"asks", scene.asks},
                          {"verdict", verdict_of(scene)},
                          {"skipped", or_null(scene.skipped)},
                          {"changes", or_null(scene.changes)},
                          {"ended", or_null(scene.ended)},
                          {"items", items},
                          {"advice", or_null(scene.advice)}});
    }
    return {{"survived", report.survived()},
            {"tried", report.tried()},
            {"not_found", report.not_found},
            {"scenes", scenes}};
}

HardScenesReport hard_scenes_from_json(const json& record) {
    HardScenesReport report;
    report.not_found = record.at("not_found").get<std::vector<std::string>>();
    for (const json& entry : record.at("scenes")) {
        HardResult scene;
        scene.name = entry.at("name");
        scene.asks = entry.at("asks");
        scene.skipped = text_of(entry.at("skipped"));
        scene.changes = text_of(entry.at("changes"));
        scene.ended = text_of(entry.at("ended"));
        for (const json& item : entry.at("items")) scene.items.push_back(item_from(item));
        // Reports of an older raygrade have none.
        if (entry.contains("advice")) scene.advice = text_of(entry.at("advice"));
        report.scenes.push_back(std::move(scene));
    }
    return report;
}

}  // namespace harness
