#include "harness/grade/run_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "harness/source/code/words.h"

namespace harness {
namespace {

using source::is_any_of;
using source::is_name;
using source::is_symbol;
using source::Word;

std::size_t line_at(const std::string& source, const Word& word) {
    return 1 + static_cast<std::size_t>(
                   std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(word.begin), '\n'));
}

/// Whether the statement reads a value from standard input. A statement that only waits for a key, `cin.get();`, does
/// not.
bool reads_value(const std::vector<Word>& words, std::size_t at) {
    const std::string_view text = words[at].text;
    if (text == "cin") return is_symbol(words, at + 1, ">>");
    if (text == "getchar") return at > 0 && is_symbol(words, at - 1, "=");
    if (text == "scanf") return is_symbol(words, at + 1, "(");
    if (!is_any_of(text, {"getline", "fgets"})) return false;
    for (std::size_t i = at < 2 ? 0 : at - 2; i < words.size() && (i < at || words[i].text != ";"); ++i) {
        if (is_any_of(words[i].text, {"cin", "stdin"}))
            return true;  // cin.getline(…), getline(cin, …), fgets(…, stdin)
    }
    return false;
}

/// Whether a matrix is declared without a value, and used in a product or a GLM function before it gets one. `mat4 m; m
/// = translate(m, v);`
bool is_used_unset(const std::vector<Word>& words, std::size_t at) {
    const bool is_matrix = is_any_of(words[at].text, {"mat2", "mat3", "mat4", "dmat3", "dmat4", "mat3x3", "mat4x4"});
    if (!is_matrix || at + 2 >= words.size() || !is_name(words[at + 1]) || !is_symbol(words, at + 2, ";")) return false;
    const std::string_view name = words[at + 1].text;
    bool is_set_here = false;
    for (std::size_t i = at + 3; i < words.size(); ++i) {
        if (words[i].text == ";" && is_set_here) return false;
        if (words[i].text != name) continue;
        if (is_symbol(words, i - 1, ".") || is_symbol(words, i - 1, "->")) return false;
        const bool is_argument = i >= 2 && is_symbol(words, i - 1, "(") &&
                                 is_any_of(words[i - 2].text, {"translate", "rotate", "scale", "inverse", "transpose"});
        if (is_argument || is_symbol(words, i + 1, "*") || is_symbol(words, i - 1, "*")) return true;
        if (!is_symbol(words, i + 1, "=")) return false;
        is_set_here = true;
    }
    return false;
}

}  // namespace

std::string run_advice(const std::string& source, const ProcessResult& run) {
    std::string advice;
    const std::vector<Word> words = source::words_of(source);
    const auto tell_first = [&](const auto& is_it, const auto& sentence) {
        for (std::size_t at = 0; at < words.size(); ++at) {
            if (!is_it(words, at)) continue;
            advice += sentence(line_at(source, words[at]), at);
            return;
        }
    };
    tell_first(reads_value, [](std::size_t line, std::size_t) {
        return fmt::format(" ray_cast.cpp:{} reads input, but the program gets none; write the values into the source.",
                           line);
    });
    tell_first(is_used_unset, [&](std::size_t line, std::size_t at) {
        return fmt::format(
            " ray_cast.cpp:{0} gives {1} no value, and GLM does not make it the identity matrix; write {2} "
            "{1}(1.0f).",
            line, words[at + 1].text, words[at].text);
    });
    if (run.errors.find("_S_create_c_locale") != std::string::npos)
        advice += " It sets a locale by name, such as \"en_US.UTF-8\", but only \"C\" exists here; remove that call.";
    if (run.output.empty() && !run.errors.empty() && run.ended == Ended::exited)
        advice += " It wrote only to standard error (std::cerr); only standard output (std::cout) is read.";
    return advice;
}

}  // namespace harness
