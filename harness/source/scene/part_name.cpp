#include "harness/source/scene/part_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/source/scene/object_source.h"

namespace harness::source {
namespace {

bool may_name_of_camera(std::string_view name, ScenePart part) {
    const std::string word = plain_name(last_word(name));
    if (part == part::eye) {
        return holds_one_of(word, {"eye", "cam", "oeil", "ojo", "viewpoint"}) ||
               is_one_of(word, {"from", "lookfrom", "position", "pos", "viewer", "e"});
    }
    if (part == part::lookat) {
        return (holds_one_of(word, {"look", "target", "cible"}) && word.find("from") == std::string::npos) ||
               is_one_of(word, {"at", "center", "centre", "ref", "focus"});
    }
    if (part == part::vup) {
        return word.ends_with("up") || word.starts_with("up") || word.starts_with("vup") || is_one_of(word, {"haut"});
    }
    return holds_one_of(word, {"pix", "dcs"});
}

}  // namespace

std::string_view to_string(ScenePart part) {
    if (part == part::eye) return "eye";
    if (part == part::lookat) return "lookat";
    if (part == part::vup) return "vup";
    if (part == part::pixel) return "pixel";
    return source_of(part.subject).parts.at(part.place).name;
}

std::string describe(const DecimalScene& scene, ScenePart part) {
    const std::array<double, 3> value = value_of(scene, part);
    switch (size_of(part)) {
        case 1: return fmt::format("{} = {}", to_string(part), value[0]);
        case 2: return fmt::format("{} = ({}, {})", to_string(part), value[0], value[1]);
        default: return fmt::format("{} = ({}, {}, {})", to_string(part), value[0], value[1], value[2]);
    }
}

bool may_name(std::string_view name, ScenePart part) {
    if (part.subject == reference::Subject::camera) return may_name_of_camera(name, part);
    return !mentions_another(name, part.subject) && source_of(part.subject).parts.at(part.place).may_name(name);
}

bool mentions(std::string_view name, reference::Subject object) {
    return holds_one_of(plain_name(name), source_of(object).words);
}

bool mentions_another(std::string_view name, reference::Subject object) {
    return std::ranges::any_of(reference::objects,
                               [&](reference::Subject other) { return other != object && mentions(name, other); });
}

std::string_view last_word(std::string_view name) {
    name = name.substr(0, name.find('['));
    return name.substr(name.find_last_of('.') + 1);
}

std::string plain_name(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c != '_') result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return result;
}

bool is_one_of(std::string_view name, Words words) {
    return std::find(words.begin(), words.end(), name) != words.end();
}

bool holds_one_of(std::string_view name, std::span<const std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string_view::npos; });
}

bool holds_one_of(std::string_view name, Words words) {
    return holds_one_of(name, std::span(words));
}

bool may_name_radius(std::string_view written, std::string_view plain) {
    if (written == "R") return true;
    if (plain.find("grad") != std::string_view::npos) return false;
    return holds_one_of(plain, {"radius", "rayon", "radio"}) ||
           is_one_of(plain, {"rad", "sr", "rs", "spherer", "sphr", "ballr", "circler", "srad", "rsphere", "sphererad"});
}

}  // namespace harness::source
