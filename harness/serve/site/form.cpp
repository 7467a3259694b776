#include "harness/serve/site/form.h"

#include <algorithm>
#include <cctype>

#include "harness/intake/intake.h"
#include "harness/intake/not_a_source.h"
#include "harness/intake/source_file.h"
#include "harness/text/printable.h"
#include "harness/text/utf8.h"

namespace harness::serve {
namespace {

constexpr std::string_view line_end = "\r\n";
/// This site's form has one part; another client may send a few more.
constexpr std::size_t most_parts = 8;
constexpr std::size_t longest_head = 4096;

bool is_same(std::string_view text, std::string_view lower) {
    return std::equal(text.begin(), text.end(), lower.begin(), lower.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
}

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

struct Parameter {
    std::string_view name;
    std::string value;
};

/// Takes `; name=value` or `; name="value"` from the front of `text`; empty if the text begins with something else.
std::optional<Parameter> take_parameter(std::string_view& text) {
    text = trimmed(text);
    if (!text.starts_with(';')) return {};
    text.remove_prefix(1);
    const auto equals = text.find('=');
    if (equals == std::string_view::npos) return {};
    Parameter parameter{trimmed(text.substr(0, equals)), {}};
    text.remove_prefix(equals + 1);
    if (!text.starts_with('"')) {
        const std::string_view value = text.substr(0, text.find(';'));
        parameter.value = trimmed(value);
        text.remove_prefix(value.size());
        return parameter;
    }
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '"') {
            text.remove_prefix(i + 1);
            return parameter;
        }
        if (text[i] == '\\' && i + 1 < text.size() && (text[i + 1] == '"' || text[i + 1] == '\\')) ++i;
        parameter.value += text[i];
    }
    return {};
}

/// Reads a part's name and kind from its header lines; empty if they have no name.
std::optional<Part> part_with(std::string_view head) {
    std::optional<Part> part;
    while (!head.empty()) {
        const std::string_view line = head.substr(0, head.find(line_end));
        head.remove_prefix(std::min(head.size(), line.size() + line_end.size()));
        const auto colon = line.find(':');
        if (colon == std::string_view::npos) return {};
        if (!is_same(trimmed(line.substr(0, colon)), "content-disposition")) continue;
        std::string_view value = trimmed(line.substr(colon + 1));
        const std::string_view kind = trimmed(value.substr(0, value.find(';')));
        if (part || !is_same(kind, "form-data")) return {};
        value.remove_prefix(std::min(value.size(), value.find(';')));
        part.emplace();
        while (const auto parameter = take_parameter(value)) {
            if (is_same(parameter->name, "name")) part->name = parameter->value;
            if (is_same(parameter->name, "filename")) part->file_name = parameter->value;
            if (is_same(parameter->name, "filename") || is_same(parameter->name, "filename*")) part->is_file = true;
        }
        if (!value.empty() || part->name.empty()) return {};
    }
    return part;
}

/// The file's name, without the folders that some browsers put before it.
std::string shown_name(const Part& part) {
    if (!part.is_file) return "pasted text";
    constexpr std::size_t longest = 100;
    const std::string name = printable(part.file_name.substr(part.file_name.find_last_of("/\\") + 1));
    return name.empty() ? "ray_cast.cpp" : std::string(beginning_of_characters(name, longest));
}

std::string with_unix_lines(std::string_view text) {
    std::string lines;
    lines.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!text.substr(i).starts_with(line_end)) lines += text[i];
    }
    return lines;
}

}  // namespace

std::optional<std::string> boundary_of(std::string_view content_type) {
    const auto end = content_type.find(';');
    if (end == std::string_view::npos || !is_same(trimmed(content_type.substr(0, end)), "multipart/form-data"))
        return {};
    std::string_view rest = content_type.substr(end);
    while (const auto parameter = take_parameter(rest)) {
        if (!is_same(parameter->name, "boundary")) continue;
        constexpr std::size_t longest = 70;
        constexpr std::string_view allowed =
            "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz'()+_,-./:=? ";
        const std::string& value = parameter->value;
        if (value.empty() || value.size() > longest || value.ends_with(' ')) return {};
        if (value.find_first_not_of(allowed) != std::string::npos) return {};
        return value;
    }
    return {};
}

std::optional<std::vector<Part>> parts_of(std::string_view body, std::string_view boundary) {
    const std::string delimiter = "\r\n--" + std::string(boundary);
    // The first delimiter needs no line end before it.
    if (!body.starts_with(std::string_view(delimiter).substr(line_end.size()))) return {};
    body.remove_prefix(delimiter.size() - line_end.size());
    std::vector<Part> parts;
    while (body.starts_with(line_end)) {
        body.remove_prefix(line_end.size());
        const auto head_end = body.substr(0, longest_head).find("\r\n\r\n");
        if (head_end == std::string_view::npos || parts.size() == most_parts) return {};
        auto part = part_with(body.substr(0, head_end));
        if (!part) return {};
        body.remove_prefix(head_end + 2 * line_end.size());
        const auto end = body.find(delimiter);
        if (end == std::string_view::npos) return {};
        part->content = body.substr(0, end);
        body.remove_prefix(end + delimiter.size());
        parts.push_back(std::move(*part));
    }
    if (!body.starts_with("--") || parts.empty()) return {};
    return parts;
}

HandedIn source_of(std::string_view content_type, std::string_view body) {
    const auto boundary = boundary_of(content_type);
    const auto parts = boundary ? parts_of(body, *boundary) : std::nullopt;
    if (!parts)
        return {{}, "This did not come from the form of this page, or part of it is missing. Please send it again."};
    const Part* found = nullptr;
    for (const Part& part : *parts) {
        if (part.name != "source") continue;
        if (found != nullptr) return {{}, "Please send one program at a time."};
        found = &part;
    }
    if (found == nullptr) return {{}, "You did not send a program. Please choose your ray_cast.cpp."};
    if (found->content.size() > largest_source_bytes)
        return {{}, "Your file is larger than 1 MiB. Please send only the source, without data or output in it."};
    HandedIn handed{
        found->is_file ? std::string(found->content) : with_unix_lines(found->content), {}, shown_name(*found)};
    if (const std::string why = why_no_source(handed.source); !why.empty()) return {{}, "What you sent " + why};
    return handed;
}

}  // namespace harness::serve
