#include "harness/report/compile_error/compiler_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>

#include "harness/text/lines.h"
#include "harness/text/utf8.h"

namespace harness::report {
namespace {

/// Every submission has this name when it is compiled.
constexpr std::string_view source_name = "ray_cast.cpp:";

/// Takes a whole number and the colon behind it from the front of `rest`; 0 when there is none.
int take_number(std::string_view& rest) {
    int number = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    if (error != std::errc() || end == rest.data() + rest.size() || *end != ':') return 0;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()) + 1);
    return number;
}

/// "ray_cast.cpp:12:5: error: …"; the column may be missing.
std::optional<CompilerMessage> read_message(std::string_view line) {
    if (!line.starts_with(source_name)) return std::nullopt;
    line.remove_prefix(source_name.size());
    CompilerMessage message;
    message.line = take_number(line);
    if (message.line <= 0) return std::nullopt;
    take_number(line);
    for (const std::string_view kind : {" error: ", " fatal error: ", " warning: "}) {
        if (!line.starts_with(kind)) continue;
        message.kind = kind == " warning: " ? "warning" : "error";
        message.text = line.substr(kind.size());
        return message;
    }
    return std::nullopt;
}

}  // namespace

std::vector<CompilerMessage> compiler_messages(std::string_view diagnostics, std::size_t most) {
    std::vector<CompilerMessage> messages;
    for (const std::string_view line : lines_of(diagnostics)) {
        if (auto message = read_message(line)) messages.push_back(std::move(*message));
    }
    std::stable_partition(messages.begin(), messages.end(),
                          [](const CompilerMessage& message) { return message.kind == "error"; });
    messages.resize(std::min(messages.size(), most));
    return messages;
}

std::string first_messages(std::string_view diagnostics) {
    constexpr std::size_t most = 40;
    const std::vector<std::string_view> lines = lines_of(diagnostics);
    std::string text;
    for (const std::string_view line : std::span(lines).first(std::min(lines.size(), most)))
        text += std::string(line) + "\n";
    if (lines.size() > most) text += fmt::format("… {} more lines\n", lines.size() - most);
    return text;
}

std::string beginning_of(const std::string& text, std::size_t most) {
    if (text.size() <= most) return text;
    const std::size_t line_end = text.rfind('\n', most);
    const auto beginning = beginning_of_characters(text, line_end == std::string::npos ? most : line_end + 1);
    return std::string(beginning) + "…\n";
}

}  // namespace harness::report
