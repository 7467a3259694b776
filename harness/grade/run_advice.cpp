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
using source::nowhere;
using source::Word;

std::size_t line_at(const std::string& source, const Word& word) {
    return 1 + static_cast<std::size_t>(
                   std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(word.begin), '\n'));
}

/// Whether the statement reads a value from standard input. A statement that only waits for a key, `cin.get();`, does
/// not.
bool reads_value(const std::vector<Word>& words, std::size_t at) {
    const std::string_view text = words[at].text;
    if (text == "scanf") return is_symbol(words, at + 1, "(");
    const std::size_t begin = at >= 2 && words[at - 2].text == "std" ? at - 2 : at;
    const auto before = [&](std::size_t count) { return begin < count ? ";" : words[begin - count].text; };
    if (text == "stdin") return before(2) != "fflush";
    const bool is_statement = is_any_of(before(1), {";", "{", "}", ")", "else"});
    if (text == "getchar") return !is_statement;
    if (text != "cin" || before(1) == "using") return false;
    const std::string_view asked = is_symbol(words, at + 1, ".") && at + 2 < words.size() ? words[at + 2].text : "";
    const bool takes_none =
        asked == "get" ? is_symbol(words, at + 4, ")") : is_any_of(asked, {"ignore", "clear", "sync", "tie"});
    return !(is_statement && takes_none);
}

bool is_matrix(const Word& word) {
    return is_any_of(word.text, {"mat2", "mat3", "mat4", "dmat3", "dmat4", "mat3x3", "mat4x4"});
}

/// Whether the words from `begin` up to `end` are a factor or an argument of a GLM function.
bool is_operand(const std::vector<Word>& words, std::size_t begin, std::size_t end) {
    if (begin < 1) return false;
    const bool is_argument = begin >= 2 && is_symbol(words, begin - 1, "(") &&
                             is_any_of(words[begin - 2].text, {"translate", "rotate", "scale", "inverse", "transpose"});
    return is_argument || is_symbol(words, end, "*") || is_symbol(words, end, "*=") || is_symbol(words, begin - 1, "*");
}

/// Whether a matrix without a value is used from `at` on, in a product or a GLM function, before it gets one: `m =
/// translate(m, v);`. Stops after most_words words, so that a hostile source does not take minutes.
bool is_used_unset(const std::vector<Word>& words, std::string_view name, std::size_t at) {
    constexpr std::size_t most_words = 3'000;
    bool is_set_here = false;
    for (std::size_t i = at; i < std::min(words.size(), at + most_words); ++i) {
        if (words[i].text == ";" && is_set_here) return false;
        if (words[i].text != name) continue;
        if (is_symbol(words, i - 1, ".") || is_symbol(words, i - 1, "->")) return false;
        if (is_operand(words, i, i + 1)) return true;
        if (!is_symbol(words, i + 1, "=")) return false;
        is_set_here = true;
    }
    return false;
}

/// The matrix that the program uses here as if GLM made it the identity: "m", declared without a value, or "mat4()".
/// Empty if there is none.
std::string unset_matrix(const std::vector<Word>& words, std::size_t at) {
    if (!is_matrix(words[at]) || at + 2 >= words.size()) return "";
    if ((words[at + 1].text == "(" || words[at + 1].text == "{") && words[at + 1].partner == at + 2) {
        const std::size_t begin = at >= 2 && is_symbol(words, at - 1, "::") ? at - 2 : at;
        const bool is_value = begin >= 2 && is_symbol(words, begin - 1, "=");
        const bool is_used =
            is_operand(words, begin, at + 3) || (is_value && is_used_unset(words, words[begin - 2].text, at + 3));
        return is_used ? std::string(words[at].text) + "()" : "";
    }
    const bool is_parameter = words[at].parent != nowhere && words[words[at].parent].text == "(";
    for (std::size_t i = at + 1; i < words.size() && is_name(words[i]) && !is_parameter; i += 2) {
        const bool is_last = !is_symbol(words, i + 1, ",");
        if (is_last && !is_symbol(words, i + 1, ";")) return "";
        if (is_used_unset(words, words[i].text, i + 1)) return std::string(words[i].text);
        if (is_last) return "";
    }
    return "";
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
    const auto is_unset = [](const std::vector<Word>& all, std::size_t at) { return !unset_matrix(all, at).empty(); };
    if (source.find("GLM_FORCE_CTOR_INIT") == std::string::npos)
        tell_first(is_unset, [&](std::size_t line, std::size_t at) {
            const std::string unset = unset_matrix(words, at);
            const std::string type(words[at].text);
            return fmt::format(" ray_cast.cpp:{}: GLM does not make {} the identity matrix; write {}(1.0f).", line,
                               unset, unset == type + "()" ? type : type + " " + unset);
        });
    if (run.errors.find("_S_create_c_locale") != std::string::npos)
        advice += " It sets a locale by name, such as \"en_US.UTF-8\", but only \"C\" exists here; remove that call.";
    const auto has_numbers = [](const std::string& text) {
        return text.find_first_of("0123456789") != std::string::npos;
    };
    if (!has_numbers(run.output) && has_numbers(run.errors) && run.ended == Ended::exited)
        advice += " It printed numbers only to standard error (std::cerr); only standard output (std::cout) is read.";
    return advice;
}

}  // namespace harness
