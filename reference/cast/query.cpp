#include "reference/cast/query.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

namespace reference::cast {
namespace {

using nlohmann::ordered_json;

double from_text(std::string_view text) {
    std::string_view digits = text;
    const bool negative = !digits.empty() && digits.front() == '-';
    if (negative) digits.remove_prefix(1);
    double x = 0;
    if (digits == "inf") {
        x = std::numeric_limits<double>::infinity();
    } else if (text == "nan") {
        return std::numeric_limits<double>::quiet_NaN();
    } else {
        const bool is_hex = digits.substr(0, 2) == "0x" || digits.substr(0, 2) == "0X";
        const std::string_view hex = is_hex ? digits.substr(2) : "";
        const auto [end, error] = std::from_chars(hex.data(), hex.data() + hex.size(), x, std::chars_format::hex);
        if (hex.empty() || hex.front() == '-' || error != std::errc() || end != hex.data() + hex.size()) {
            throw MalformedQuery(fmt::format("\"{}\" is not a hex float that a double holds", text));
        }
    }
    return negative ? -x : x;
}

void read_field(double& x, const ordered_json& value, std::string_view what) {
    if (!value.is_number() && !value.is_string()) {
        throw MalformedQuery(fmt::format("{} must be made of numbers", what));
    }
    x = value.is_number() ? value.get<double>() : from_text(value.get_ref<const std::string&>());
}

const ordered_json& array(const ordered_json& value, std::string_view what) {
    if (!value.is_array()) throw MalformedQuery(fmt::format("{} must be an array", what));
    return value;
}

void read_field(Vec3<double>& p, const ordered_json& value, std::string_view what) {
    if (array(value, what).size() != 3) throw MalformedQuery(fmt::format("{} must have three numbers", what));
    for (int i = 0; i < 3; ++i) read_field(p[i], value[static_cast<std::size_t>(i)], what);
}

/// "one center, one radius and one height" for the word "one ".
std::string listed(const std::vector<std::string_view>& names, std::string_view word) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
        text += fmt::format("{}{}", word, names[i]);
    }
    return text;
}

template <class Object>
void read_object(const ordered_json& value, std::string_view kind, Object& object) {
    if (!value.is_object()) throw MalformedQuery(fmt::format("a {} must be an object", kind));
    std::size_t count = 0;
    for (const auto& [key, of_key] : value.items()) {
        const std::size_t before = count;
        for_each_field(
            [&, &key = key, &of_key = of_key](std::string_view name, auto& field) {
                if (name != key) return;
                read_field(field, of_key, key);
                ++count;
            },
            object);
        if (count != before) continue;
        const std::vector<std::string_view> names = field_names<Object>();
        throw MalformedQuery(fmt::format("a {} has {}; \"{}\" is {} or double", kind, listed(names, "one "), key,
                                         names.size() == 2 ? "neither" : "none"));
    }
    if (count != field_names<Object>().size())
        throw MalformedQuery(fmt::format("a {} must have {}", kind, listed(field_names<Object>(), "a ")));
}

/// A triangle is the list of its vertices.
void read_object(const ordered_json& value, std::string_view /*kind*/, Triangle<double>& triangle) {
    if (array(value, "a triangle").size() != 3) throw MalformedQuery("a triangle must have three vertices");
    read_field(triangle.A, value[0], "a vertex");
    read_field(triangle.B, value[1], "a vertex");
    read_field(triangle.C, value[2], "a vertex");
}

[[noreturn]] void fail_for_key(std::string_view key) {
    std::vector<std::string> lists;
    for (const Subject kind : objects) lists.push_back(fmt::format("{}s", to_string(kind)));
    std::vector<std::string_view> keys{"origin", "direction"};
    keys.insert(keys.end(), lists.begin(), lists.end());
    throw MalformedQuery(fmt::format("\"{}\" is not a key; there are {}", key, listed(keys, "")));
}

void read_value(const std::string& key, const ordered_json& value, Query& query) {
    if (key == "origin") return read_field(query.ray.origin, value, key);
    if (key == "direction") return read_field(query.ray.direction, value, key);
    bool is_known = false;
    for_each_kind(
        [&](Subject kind, auto& of_kind) {
            if (key != fmt::format("{}s", to_string(kind))) return;
            is_known = true;
            for (const ordered_json& object : array(value, key)) {
                read_object(object, to_string(kind), of_kind.emplace_back());
            }
        },
        query.objects);
    if (!is_known) fail_for_key(key);
}

/// The JSON library keeps the last of several values with the same key, so their keys are compared while it parses.
ordered_json parse(std::string_view line) {
    using Event = ordered_json::parse_event_t;
    std::vector<std::set<std::string>> keys;  // of each object that is open
    const auto refuse_doubles = [&](int /*depth*/, Event event, ordered_json& parsed) {
        if (event == Event::object_start) keys.emplace_back();
        if (event == Event::object_end) keys.pop_back();
        if (event == Event::key && !keys.back().insert(parsed.get<std::string>()).second) {
            throw MalformedQuery(fmt::format("\"{}\" is there twice", parsed.get_ref<const std::string&>()));
        }
        return true;
    };
    try {
        return ordered_json::parse(line, refuse_doubles);
    } catch (const ordered_json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, …"
        const std::string_view message = error.what();
        throw MalformedQuery(std::string(message.substr(message.find("] ") + 2)));
    }
}

}  // namespace

Query read_query(std::string_view line) {
    const ordered_json json = parse(line);
    if (!json.is_object()) throw MalformedQuery("a query must be an object");
    Query query;
    for (const auto& [key, value] : json.items()) read_value(key, value, query);
    if (!json.contains("origin") || !json.contains("direction")) {
        throw MalformedQuery("a query must have an origin and a direction");
    }
    return query;
}

}  // namespace reference::cast
