#include "harness/scenes/source/part_name.h"

#include <algorithm>
#include <initializer_list>

namespace harness::scenes {
namespace {

/// The last word of a name: "C" of "spheres[0].C".
std::string_view last_word(std::string_view name) {
    name = name.substr(0, name.find('['));
    return name.substr(name.find_last_of('.') + 1);
}

/// The name in lower case and without underscores.
std::string plain_name(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c != '_') result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return result;
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), name) != words.end();
}

bool holds_one_of(std::string_view name, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string_view::npos; });
}

/// Whether the name may mean the radius. "r" alone does not: the window's right edge is called r or clipR.
bool may_name_radius(std::string_view written, std::string_view name) {
    if (written == "R") return true;
    if (name.find("grad") != std::string_view::npos) return false;
    return holds_one_of(name, {"radius", "rayon", "radio"}) ||
           is_one_of(name, {"rad", "sr", "rs", "spherer", "sphr", "ballr", "circler", "srad", "rsphere", "sphererad"});
}

bool is_vertex(std::string_view name, char letter, char number) {
    if (name.size() == 1) return name[0] == letter;
    const bool of_triangle =
        holds_one_of(name, {"tri", "vert", "corner"}) || (name.size() == 2 && holds_one_of(name, {"t", "v", "p"}));
    return of_triangle && (name.back() == letter || name.back() == number);
}

}  // namespace

bool may_name(std::string_view name, ScenePart part) {
    const std::string_view written = last_word(name);
    const std::string word = plain_name(written);
    switch (part) {
        case ScenePart::eye:
            return holds_one_of(word, {"eye", "cam", "oeil", "ojo", "viewpoint"}) ||
                   is_one_of(word, {"from", "lookfrom", "position", "pos", "viewer", "e"});
        case ScenePart::lookat:
            return (holds_one_of(word, {"look", "target", "cible"}) && word.find("from") == std::string::npos) ||
                   is_one_of(word, {"at", "center", "centre", "ref", "focus"});
        case ScenePart::vup:
            return word.ends_with("up") || word.starts_with("up") || word.starts_with("vup") ||
                   is_one_of(word, {"haut"});
        case ScenePart::center:
            return holds_one_of(word, {"cen", "sph", "ball", "circle"}) || is_one_of(word, {"c", "sc", "cs", "o"});
        case ScenePart::radius: return may_name_radius(written, word);
        case ScenePart::A: return is_vertex(word, 'a', '1');
        case ScenePart::B: return is_vertex(word, 'b', '2');
        case ScenePart::C: return is_vertex(word, 'c', '3');
        case ScenePart::pixel: return holds_one_of(word, {"pix", "dcs"});
    }
    return false;
}

}  // namespace harness::scenes
