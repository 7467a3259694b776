#include "harness/review/form_fields.h"

#include <algorithm>
#include <charconv>

namespace harness::review {
namespace {

/// A decision for many students of a class of 10,000 has a field for each.
constexpr std::size_t most_fields = 20'000;

/// Empty if a '%' is not followed by two hexadecimal digits.
std::optional<std::string> decoded(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            plain += text[i] == '+' ? ' ' : text[i];
            continue;
        }
        unsigned char byte = 0;
        if (text.size() - i < 3) return std::nullopt;
        const auto [end, error] = std::from_chars(text.data() + i + 1, text.data() + i + 3, byte, 16);
        if (error != std::errc() || end != text.data() + i + 3) return std::nullopt;
        plain += static_cast<char>(byte);
        i += 2;
    }
    return plain;
}

}  // namespace

std::string FormFields::value(std::string_view name) const {
    const auto found =
        std::find_if(fields_.begin(), fields_.end(), [&](const auto& field) { return field.first == name; });
    return found == fields_.end() ? "" : found->second;
}

std::vector<std::string> FormFields::values(std::string_view name) const {
    std::vector<std::string> all;
    for (const auto& [each, value] : fields_) {
        if (each == name) all.push_back(value);
    }
    return all;
}

std::optional<FormFields> read_form(std::string_view content_type, std::string_view body) {
    if (content_type.substr(0, content_type.find(';')) != "application/x-www-form-urlencoded") return std::nullopt;
    std::vector<std::pair<std::string, std::string>> fields;
    while (!body.empty()) {
        const std::string_view field = body.substr(0, body.find('&'));
        body.remove_prefix(std::min(body.size(), field.size() + 1));
        if (field.empty()) continue;
        const std::size_t equals = std::min(field.find('='), field.size());
        auto name = decoded(field.substr(0, equals));
        auto value = decoded(field.substr(std::min(field.size(), equals + 1)));
        if (!name || !value || fields.size() == most_fields) return std::nullopt;
        fields.emplace_back(std::move(*name), std::move(*value));
    }
    return FormFields(std::move(fields));
}

}  // namespace harness::review
