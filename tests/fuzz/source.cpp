#include <algorithm>
#include <string>
#include <vector>

#include "harness/source/code/constant.h"
#include "harness/source/code/cpp_lexer.h"
#include "harness/source/code/words.h"
#include "harness/source/scene/scene_literals.h"
#include "harness/source/scene/stated_scene.h"
#include "reference/toml/assignment.h"
#include "reference/toml/scene_toml.h"
#include "tests/fuzz/properties.h"

namespace {

using namespace harness::source;

const DecimalScene& scene_of_the_assignment() {
    static const reference::Assignment a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    return a6.scene;
}

/// A scene whose numbers all differ from the assignment's and from each other; many are negative, which changes the
/// most around them.
DecimalScene changed_scene(bool whole) {
    int next = 10;
    const auto number = [&] {
        ++next;
        const std::string text = (next % 3 == 0 ? "" : "-") + std::to_string(next) + (whole ? "" : ".25");
        return reference::Decimal::parse(text).value();
    };
    const auto vector = [&] {
        const auto x = number(), y = number(), z = number();
        return reference::Vec3<reference::Decimal>(x, y, z);
    };
    DecimalScene other = scene_of_the_assignment();
    other.camera = {vector(), vector(), vector()};
    other.spheres.front() = {vector(), reference::Decimal::parse(whole ? "24" : "24.25").value()};
    other.triangles.front() = {vector(), vector(), vector()};
    other.pixel = {41, 42};
    return other;
}

std::string check_tokens(std::string_view source, const std::vector<Token>& tokens) {
    std::size_t end = 0;
    for (const Token& token : tokens) {
        if (token.begin != end || token.end <= token.begin) return "tokens that leave out a part of the source";
        end = token.end;
    }
    return end == source.size() ? "" : "tokens that end before or behind the source";
}

std::string check_words(std::string_view source) {
    const std::vector<Word> words = words_of(source);
    std::size_t last = 0;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Word& word = words[i];
        if (word.begin < last || word.begin > source.size()) return "words out of order";
        last = word.begin;
        if (source.substr(word.begin, word.text.size()) != word.text) return "a word that is not in the source";
        if (word.partner != nowhere && (word.partner >= words.size() || words[word.partner].partner != i))
            return "a bracket whose partner has another";
        if (word.parent != nowhere && (word.parent >= i || words[word.parent].text.size() != 1))
            return "a word in a bracket that does not stand before it";
    }
    return {};
}

/// The tokens' texts, apart from blanks and comments, of the part of a source before or behind a number.
std::vector<std::string_view> code_of(std::string_view source, std::size_t begin, std::size_t end) {
    std::vector<std::string_view> texts;
    for (const Token& token : lex_cpp(source)) {
        if (token.kind == TokenKind::blank || token.kind == TokenKind::comment || token.end <= begin) continue;
        if (token.begin >= end) break;
        texts.push_back(source.substr(token.begin, token.end - token.begin));
    }
    return texts;
}

/// Whether the source, where it does not state the scene, has the same tokens after the scene is written into it.
std::string check_rewritten(std::string_view source, const SceneLiterals& found, const DecimalScene& other) {
    const auto written = with_scene(source, found, other);
    if (!written) return {};
    std::size_t before = 0;  // the end of the last number, in the source
    std::size_t at = 0;      // the same place in what was written
    for (std::size_t i = 0; i <= found.literals.size(); ++i) {
        const bool is_last = i == found.literals.size();
        const std::size_t end = is_last ? source.size() : found.literals[i].begin;
        const std::string_view gap = source.substr(before, end - before);
        if (!std::string_view(*written).substr(at).starts_with(gap)) return "a change beside the scene's numbers";
        if (code_of(source, before, end) != code_of(*written, at, at + gap.size()))
            return "a number that becomes one token with what stands beside it: " + *written;
        at += gap.size();
        if (is_last) return at == written->size() ? "" : "more behind the source";
        const SceneLiteral& literal = found.literals[i];
        before = literal.end;
        // The number ends where the next gap begins, if it is written as spell() says.
        const auto value = value_of(other, literal.part);
        std::string number;
        for (std::size_t k = literal.splat ? 0 : literal.component; k < (literal.splat ? 3 : literal.component + 1);
             ++k) {
            std::string text = spell(value.at(k) + literal.offset, literal.constant).value_or("");
            if (literal.in_define && text.starts_with('-')) text = "(" + text + ")";
            number += (number.empty() ? "" : ", ") + text;
        }
        if (!std::string_view(*written).substr(at).starts_with(number)) return "a number of another value";
        const auto constant = evaluate(words_of(literal.splat ? "0" : number));
        if (!literal.splat && (!constant || constant->value != value.at(literal.component) + literal.offset))
            return "a number that is read otherwise than it was written: " + number;
        at += number.size();
    }
    return {};
}

std::string check_literals(std::string_view source) {
    const SceneLiterals found = find_scene(source, scene_of_the_assignment());
    std::size_t end = 0;
    PartSet parts;
    for (const SceneLiteral& literal : found.literals) {
        if (literal.begin < end || literal.end <= literal.begin || literal.end > source.size())
            return "numbers of the scene that overlap";
        end = literal.end;
        parts.insert(literal.part);
        if (literal.component >= size_of(literal.part)) return "a component that the part has not";
        const double stated = value_of(scene_of_the_assignment(), literal.part).at(literal.component) + literal.offset;
        if (literal.constant.value != stated) return "a number that is not the scene's";
    }
    if (!(parts == found.located)) return "a part that is located nowhere";
    for (const bool whole : {true, false}) {
        if (std::string broken = check_rewritten(source, found, changed_scene(whole)); !broken.empty()) return broken;
    }
    const auto same = with_scene(source, found, scene_of_the_assignment());
    if (!same) return "the scene's own numbers can't be written in their places";
    if (find_scene(*same, scene_of_the_assignment()).located != found.located)
        return "the scene is found no more where it was written";
    return {};
}

std::string check_stated(std::string_view source) {
    constexpr std::size_t most = 12;
    const std::vector<StatedScene> stated = stated_scenes(source, scene_of_the_assignment());
    if (stated.size() > most) return "more stated scenes than the limit";
    for (const StatedScene& one : stated) {
        if (one.parts.empty()) return "a stated scene that states nothing else";
        if (scene_toml(one.scene) == scene_toml(scene_of_the_assignment()))
            return "a stated scene that is the assignment's";
        for (const OtherPart& part : one.parts) {
            if (part.stated == part.given) return "a part that is stated as it was given: " + part.name;
        }
        if (describe(one.parts).empty()) return "a stated scene without words";
    }
    return {};
}

}  // namespace

std::string check_source(std::string_view source) {
    if (std::string broken = check_tokens(source, lex_cpp(source)); !broken.empty()) return broken;
    if (std::string broken = check_words(source); !broken.empty()) return broken;
    if (std::string broken = check_literals(source); !broken.empty()) return broken;
    return check_stated(source);
}
