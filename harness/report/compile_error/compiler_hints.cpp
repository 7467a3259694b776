#include "harness/report/compile_error/compiler_hints.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

#include "harness/report/compile_error/compiler_messages.h"
#include "harness/report/compile_error/known_headers.h"
#include "harness/text/encoding.h"
#include "harness/text/escape.h"
#include "harness/text/lines.h"
#include "harness/text/lower_case.h"

namespace harness::report {
namespace {

/// The texts in quotes, 'like this'.
std::vector<std::string> quoted_texts(std::string_view message) {
    std::vector<std::string> all;
    for (std::size_t begin = message.find('\''); begin != std::string_view::npos; begin = message.find('\'', begin)) {
        const std::size_t end = message.find('\'', begin + 1);
        if (end == std::string_view::npos) break;
        all.emplace_back(message.substr(begin + 1, end - begin - 1));
        begin = end + 1;
    }
    return all;
}

bool is_number(std::string_view type) {
    if (type.starts_with("const ")) type.remove_prefix(6);
    constexpr std::string_view numbers[] = {"double", "int", "long", "long double", "unsigned int", "size_t", "float"};
    return std::find(std::begin(numbers), std::end(numbers), type) != std::end(numbers);
}

bool is_of_glm(std::string_view type) {
    return type.find("glm::") != std::string_view::npos || type.find("vec") == 0 || type.find("mat") == 0;
}

/// A line of the source; empty beyond its end.
std::string_view line_of(std::string_view source, int number) {
    const std::vector<std::string_view> lines = lines_of(source);
    return 1 <= number && number <= static_cast<int>(lines.size()) ? lines[static_cast<std::size_t>(number) - 1] : "";
}

/// "no match for 'operator*' (operand types are 'double' and 'glm::vec3' {aka …})".
std::string about_operands(const CompilerMessage& message) {
    constexpr std::string_view begin = "no match for 'operator", middle = "(operand types are '";
    const std::size_t operands = message.text.find(middle);
    if (!message.text.starts_with(begin) || operands == std::string::npos) return "";
    const std::string sign = quoted_texts(message.text).front().substr(std::string_view("operator").size());
    // "'glm::vec3' {aka 'glm::vec<3, float, …>'}": the first name is the usual one.
    const std::string types = message.text.substr(operands + middle.size() - 1);
    const std::size_t second = types.find(" and '");
    if (second == std::string::npos) return "";
    const std::string left = quoted_texts(types).front(), right = quoted_texts(types.substr(second)).front();
    if (sign != "*" && sign != "/" && sign != "+" && sign != "-") return "";
    const std::string none = fmt::format("Line {}: GLM has no {} for {} and {}", message.line, sign, left, right);
    const bool one_number = is_number(left) != is_number(right);
    if (one_number && (is_of_glm(left) || is_of_glm(right))) {
        const std::string& number = is_number(left) ? left : right;
        if (number != "float" && number != "const float") {
            return fmt::format(
                "{}. Make the number a float: declare it as float, or write float(x) for x and 2.0f for 2.0.", none);
        }
    }
    const bool is_double = (left.find("glm::d") != std::string::npos) != (right.find("glm::d") != std::string::npos);
    if (is_of_glm(left) && is_of_glm(right) && is_double)
        return none + ". Use the same kind on both sides: vec3 and mat4, or dvec3 and dmat4.";
    const auto are = [&](std::string_view one, std::string_view other) {
        return (left.ends_with(one) && right.ends_with(other)) || (left.ends_with(other) && right.ends_with(one));
    };
    if (sign == "*" && are("mat4", "vec3"))
        return none + ". A mat4 multiplies a vec4: give the vec3 a fourth component.";
    return "";
}

/// Whether names of std may go without their prefix.
bool names_std(std::string_view source) {
    return source.find("using namespace std") != std::string_view::npos;
}

std::string include_at_the_top(std::string_view name, std::string_view header) {
    const bool is_standard = !header.starts_with("glm/");
    return fmt::format("{} needs #include <{}> at the top of the source.{}", name, header,
                       // With each version of the compiler, standard headers include fewer others.
                       is_standard ? " Other versions of the compiler may accept the program without it." : "");
}

/// "'setprecision' is not a member of 'std'", "'sqrt' was not declared in this scope", "'glm' has not been declared".
std::string about_a_name(const CompilerMessage& message, std::string_view source) {
    const auto names = quoted_texts(message.text);
    if (names.empty()) return "";
    std::string name = names.front();
    if (message.text.find("is not a member of") != std::string::npos && names.size() > 1) {
        name = names[1] + "::" + name;
    } else if (message.text.find("declared") == std::string::npos &&
               message.text.find("is not a namespace-name") == std::string::npos) {
        return "";
    }
    std::string_view header = header_of_name(name);
    if (header.empty() && names_std(source)) header = header_of_name("std::" + name);
    if (header.empty()) return "";
    return fmt::format("Line {}: {}", message.line, include_at_the_top(name, header));
}

std::string of_newer_standard(int line, const std::string& what) {
    return fmt::format("Line {}: {} needs C++20 or newer, but programs are compiled as C++17. Do not use it.", line,
                       what);
}

/// "'std::numbers' has not been declared", "'lerp' is not a member of 'std'", "'std::string' has no member named
/// 'starts_with'", "expected primary-expression before '>'" for <=>, "'concept' does not name a type", "'using enum'
/// only available with '-std=c++20'".
std::string about_a_newer_standard(const CompilerMessage& message, std::string_view source) {
    const auto names = quoted_texts(message.text);
    const auto says = [&](const char* text) { return message.text.find(text) != std::string::npos; };
    if (says("only available with '-std=c++2") && !names.empty()) return of_newer_standard(message.line, names.front());
    for (std::string name : names) {
        const bool is_in_std = name.starts_with("std::");
        if (is_in_std) name.erase(0, 5);
        const bool is_keyword =
            name == "concept" || name == "requires" || name == "consteval" || name == "constinit" || name == "char8_t";
        // Without std::, other names are more often the program's own.
        const bool is_rare =
            name == "numbers" || name == "ranges" || name == "lerp" || name == "span" || name == "format";
        const bool is_missing = is_in_std || says("'std'") || (says("std::") && says("has no member named")) ||
                                (is_rare && names_std(source));
        if (is_of_newer_standard(name) && (is_keyword || is_missing))
            return of_newer_standard(message.line, is_keyword ? name : "std::" + name);
    }
    const bool compares = message.text.find("before '>' token") != std::string::npos &&
                          line_of(source, message.line).find("<=>") != std::string_view::npos;
    return compares ? of_newer_standard(message.line, "<=>") : "";
}

/// "extended character “ is not valid in an identifier", "stray '\\240' in program", "stray '`' in program": text
/// copied from a page, or with its marks for code.
std::string about_a_character(const CompilerMessage& message, std::string_view source) {
    if (!message.text.starts_with("extended character") && !message.text.starts_with("stray ") &&
        message.text.find("'\\U000") == std::string::npos)
        return "";
    std::string line(line_of(source, message.line));
    if (!composed(line)) line = utf8_from("CP1252", line);
    if (line.find("```") != std::string_view::npos)
        return fmt::format("Line {}: ``` marks code on web pages and in chats; it is not C++. Delete these lines.",
                           message.line);
    constexpr std::pair<std::string_view, const char*> lookalikes[] = {
        {"\u00a0", "a no-break space instead of a space"},
        {"\u202f", "a no-break space instead of a space"},
        {"\u2003", "a wide space instead of a space"},
        {"\u3000", "a wide space instead of a space"},
        {"\u200b", "an invisible character"},
        {"\ufeff", "an invisible character"},
        {"\u201c", "a curly quote “ instead of \""},
        {"\u201d", "a curly quote ” instead of \""},
        {"\u2018", "a curly quote ‘ instead of '"},
        {"\u2019", "a curly quote ’ instead of '"},
        {"\u2013", "a dash – instead of the minus sign -"},
        {"\u2014", "a dash — instead of the minus sign -"},
        {"\u2212", "the sign − instead of the minus sign -"},
    };
    for (const auto& [character, what] : lookalikes) {
        if (line.find(character) == std::string::npos) continue;
        return fmt::format("Line {}: there is {}, probably copied from a PDF or a web page. Retype it.", message.line,
                           what);
    }
    return "";
}

/// "windows.h: No such file or directory".
std::string about_a_header(const CompilerMessage& message, std::string_view source) {
    constexpr std::string_view missing = ": No such file or directory";
    if (!message.text.ends_with(missing)) return "";
    const std::string header = message.text.substr(0, message.text.size() - missing.size());
    if (const std::string_view system = system_of_header(header); !system.empty()) {
        return fmt::format(
            "Line {}: {} is a header of {}, but programs are compiled on Linux. Remove it and the code that needs it.",
            message.line, header, system);
    }
    if (is_of_newer_standard(header)) return of_newer_standard(message.line, "<" + header + ">");
    if (const std::string known = header_meant(header); !known.empty()) {
        const bool is_case = lower_case(known) == lower_case(header);
        return fmt::format("Line {}: write #include <{}>{}.", message.line, known,
                           is_case ? "; on Linux, file names are case-sensitive" : "");
    }
    const bool is_own = source.find("\"" + header + "\"") != std::string_view::npos;
    return fmt::format("Line {}: the grader does not have {}{}", message.line, header,
                       is_own ? ", because you hand in only one source file. Copy the code you need into that file."
                              : ". Use the standard library and GLM, or copy the code you need into your source.");
}

/// "expected ',' or ';' before 'glm'" names the next line, "expected ';' before '}' token" the line itself.
std::string about_a_semicolon(const CompilerMessage& message, std::string_view source) {
    constexpr std::string_view either = "expected ',' or ';' before '", sure = "expected ';' before '";
    const bool is_behind = message.text.starts_with(either);
    const bool is_character = message.text.find("'\\U") != std::string::npos;
    if ((!is_behind && !message.text.starts_with(sure)) || is_character) return "";
    int number = message.line;
    if (is_behind) {
        const std::vector<std::string_view> lines = lines_of(source);
        const auto begins = [&](int line) {
            const std::string_view text = lines[static_cast<std::size_t>(line) - 1];
            return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
        };
        const auto next = quoted_texts(message.text.substr(either.size() - 1));
        const bool is_there = 1 < number && number <= static_cast<int>(lines.size());
        if (next.empty() || !is_there || !begins(number).starts_with(next.front())) return "";
        const auto is_passed_over = [&](std::string_view text) { return text.empty() || text.starts_with("//"); };
        for (--number; number > 0 && is_passed_over(begins(number));) --number;
        if (number < 1) return "";
    }
    return fmt::format("Line {}: this statement needs a ; at its end.", number);
}

/// "note: 'std::cout' is defined in header '<iostream>'; did you forget to '#include <iostream>'?"
std::string about_a_note(std::string_view line) {
    constexpr std::string_view defined = "is defined in header '";
    // A note about a line of a header is the consequence of another mistake.
    if (!line.starts_with("ray_cast.cpp:") || line.find(": note: ") == std::string_view::npos ||
        line.find(defined) == std::string_view::npos || line.find("only available from") != std::string_view::npos)
        return "";
    const auto names = quoted_texts(line);
    if (names.size() < 2 || names[1].size() < 2 || names[1].front() != '<') return "";
    return include_at_the_top(names[0], std::string_view(names[1]).substr(1, names[1].size() - 2));
}

/// "undefined reference to `main'", "undefined symbol: main".
bool says_no_main(std::string_view line) {
    for (const std::string_view begin :
         {"undefined reference to `", "undefined reference to '", "undefined symbol: "}) {
        const std::size_t at = line.find(begin);
        if (at == std::string_view::npos) continue;
        const std::string_view name = line.substr(at + begin.size());
        if (name == "main" || name.starts_with("main'")) return true;
    }
    return false;
}

/// The name before the first "(" of a line such as "int Main() {".
std::string_view function_begun_in(std::string_view line) {
    const std::size_t open = line.find('(');
    if (open == std::string_view::npos || line.empty() || std::isspace(static_cast<unsigned char>(line.front())) != 0)
        return "";
    const auto is_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    std::size_t end = open;
    while (end > 0 && line[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin > 0 && is_of_name(line[begin - 1])) --begin;
    return line.substr(begin, end - begin);
}

bool is_like_main(std::string_view name) {
    std::string small = lower_case(name);
    if (small.find("main") != std::string::npos) return true;
    std::sort(small.begin(), small.end());
    return small == "aimn";  // "mian"
}

std::string about_main(std::string_view source) {
    int number = 0;
    for (const std::string_view line : lines_of(source)) {
        ++number;
        const std::string_view name = function_begun_in(line);
        if (name != "main" && is_like_main(name)) {
            return fmt::format("The source has no main function. Line {}: should {} be main?", number, name);
        }
    }
    return "The source has no main function. Write int main() { … }.";
}

/// GLM's own message, from one of its headers.
bool wants_experimental(std::string_view line) {
    return line.find(" error: ") != std::string_view::npos &&
           line.find("GLM_ENABLE_EXPERIMENTAL") != std::string_view::npos;
}

/// g++'s quotation marks in a locale other than C.
std::string with_plain_quotes(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view next = text.substr(i, 3);
        const bool is_quote = next == "\xE2\x80\x98" || next == "\xE2\x80\x99";
        plain += is_quote ? '\'' : text[i];
        if (is_quote) i += 2;
    }
    return plain;
}

std::string hint_of(std::string_view line, std::string_view source) {
    if (says_no_main(line)) return about_main(source);
    if (wants_experimental(line))
        return "Write #define GLM_ENABLE_EXPERIMENTAL above the first #include; GLM's gtx headers need it.";
    if (line.find("can never be inlined because it uses variable argument lists") != std::string_view::npos)
        return "Remove #define GLM_FORCE_INLINE; g++ can't compile GLM's string_cast.hpp with it.";
    if (std::string hint = about_a_note(line); !hint.empty()) return hint;
    const auto messages = compiler_messages(line, 1);
    if (messages.empty() || messages.front().kind != "error") return "";
    for (const std::string& hint :
         {about_a_character(messages.front(), source), about_a_newer_standard(messages.front(), source),
          about_operands(messages.front()), about_a_name(messages.front(), source),
          about_a_header(messages.front(), source), about_a_semicolon(messages.front(), source)}) {
        if (!hint.empty()) return hint;
    }
    return "";
}

}  // namespace

std::vector<std::string> compiler_hints(std::string_view diagnostics, std::string_view source, std::size_t most) {
    std::vector<std::string> hints;
    const std::string plain = with_plain_quotes(diagnostics);
    for (const std::string_view line : lines_of(plain)) {
        if (hints.size() == most) break;
        const std::string hint = hint_of(line, source);
        if (!hint.empty() && std::find(hints.begin(), hints.end(), hint) == hints.end()) hints.push_back(hint);
    }
    return hints;
}

std::vector<std::string> compiler_hints(const Graded& graded) {
    if (graded.execution.outcome != Outcome::compile_error) return {};
    return compiler_hints(graded.execution.build.diagnostics, graded.submission.source);
}

std::string compiler_text(const Graded& graded) {
    std::string text;
    for (const std::string& hint : compiler_hints(graded)) text += escape_control(hint) + "\n";
    if (!graded.execution.build.diagnostics.empty()) {
        const std::string& compiler = graded.execution.compiler;
        text += fmt::format("\nMessages from {}:\n{}", compiler.empty() ? "the compiler" : compiler,
                            escape_control(first_messages(graded.execution.build.diagnostics)));
    }
    return text;
}

}  // namespace harness::report
