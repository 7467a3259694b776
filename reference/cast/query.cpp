#include "reference/cast/query.h"

#include <fmt/format.h>
#include <simdjson.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "reference/cast/blocks.h"

namespace reference::cast {
namespace {

namespace json = simdjson::dom;

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

double number(const json::element& element, std::string_view what) {
    double x = 0;
    if (element.get(x) == simdjson::SUCCESS) return x;
    std::string_view text;
    if (element.get(text) == simdjson::SUCCESS) return from_text(text);
    throw MalformedQuery(fmt::format("{} must be made of numbers", what));
}

json::array array(const json::element& element, std::string_view what) {
    json::array values;
    if (element.get(values) != simdjson::SUCCESS) throw MalformedQuery(fmt::format("{} must be an array", what));
    return values;
}

Vec3<double> point(const json::element& element, std::string_view what) {
    double numbers[3] = {};
    std::size_t count = 0;
    for (const json::element& value : array(element, what)) {
        if (count < 3) numbers[count] = number(value, what);
        ++count;
    }
    if (count != 3) throw MalformedQuery(fmt::format("{} must have three numbers", what));
    return {numbers[0], numbers[1], numbers[2]};
}

/// "one center, one radius and one height" for the word "one".
std::string listed(const std::vector<std::string_view>& names, std::string_view word) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
        text += fmt::format("{}{}{}", word, word.empty() ? "" : " ", names[i]);
    }
    return text;
}

void read_field(double& x, const json::element& value, std::string_view key) {
    x = number(value, key);
}
void read_field(Vec3<double>& p, const json::element& value, std::string_view key) {
    p = point(value, key);
}

template <class Object>
void read_object(const json::element& element, std::string_view kind, Object& object) {
    json::object fields;
    if (element.get(fields) != simdjson::SUCCESS) throw MalformedQuery(fmt::format("a {} must be an object", kind));
    unsigned read = 0;  // a bit for each field
    for (const auto& [key, value] : fields) {
        const unsigned before = read;
        unsigned bit = 1;
        for_each_field(
            [&, &key = key, &value = value](std::string_view name, auto& field) {
                if (name == key && (read & bit) == 0) {
                    read_field(field, value, key);
                    read |= bit;
                }
                bit <<= 1U;
            },
            object);
        if (read != before) continue;
        const std::vector<std::string_view> names = field_names<Object>();
        throw MalformedQuery(fmt::format("a {} has {}; \"{}\" is {} or double", kind, listed(names, "one"), key,
                                         names.size() == 2 ? "neither" : "none"));
    }
    unsigned every = 0;
    for_each_field([&](std::string_view /*name*/, const auto& /*field*/) { every = 2 * every + 1; }, object);
    if (read != every) throw MalformedQuery(fmt::format("a {} must have {}", kind, listed(field_names<Object>(), "a")));
}

/// A triangle is the list of its vertices.
void read_object(const json::element& element, std::string_view /*kind*/, Triangle<double>& triangle) {
    const json::array vertices = array(element, "a triangle");
    if (vertices.size() != 3) throw MalformedQuery("a triangle must have three vertices");
    auto vertex = vertices.begin();
    for (Vec3<double>* p : {&triangle.A, &triangle.B, &triangle.C}) {
        *p = point(*vertex, "a vertex");
        ++vertex;
    }
}

/// Whether the key is "spheres" for spheres, and so on.
bool is_list_of(std::string_view key, Subject kind) {
    const std::string_view one = to_string(kind);
    return key.size() == one.size() + 1 && key.starts_with(one) && key.back() == 's';
}

[[noreturn]] void fail_for_key(std::string_view key) {
    std::vector<std::string> lists;
    for (const Subject kind : objects) lists.push_back(fmt::format("{}s", to_string(kind)));
    std::vector<std::string_view> keys{"origin", "direction"};
    keys.insert(keys.end(), lists.begin(), lists.end());
    throw MalformedQuery(fmt::format("\"{}\" is not a key; there are {}", key, listed(keys, "")));
}

void read_value(std::string_view key, const json::element& value, Query& query) {
    if (key == "origin") {
        query.ray.origin = point(value, key);
        return;
    }
    if (key == "direction") {
        query.ray.direction = point(value, key);
        return;
    }
    bool is_known = false;
    for_each_kind(
        [&](Subject kind, auto& of_kind) {
            if (!is_list_of(key, kind)) return;
            is_known = true;
            for (const json::element& element : array(value, key))
                read_object(element, to_string(kind), of_kind.emplace_back());
        },
        query.objects);
    if (!is_known) fail_for_key(key);
}

/// The same JSON where whole numbers of 19 digits and more are written with an exponent, as simdjson reads no whole
/// number beyond 2^64.
std::string with_exponents(std::string_view line) {
    constexpr std::size_t long_number = 19;
    std::string result;
    bool in_string = false;
    while (!line.empty()) {
        const bool is_number = !in_string && (line.front() == '-' || ('0' <= line.front() && line.front() <= '9'));
        std::size_t length = is_number ? line.find_first_not_of("0123456789+-.eE") : 1;
        if (in_string && line.front() == '\\') length = 2;
        if (line.front() == '"') in_string = !in_string;
        const std::string_view token = line.substr(0, length);
        result += token;
        if (is_number && token.size() >= long_number && token.find_first_of(".eE") == std::string_view::npos)
            result += "e0";
        line.remove_prefix(token.size());
    }
    return result;
}

}  // namespace

struct QueryReader::Parser {
    json::parser json;
};

QueryReader::QueryReader() : parser_(std::make_unique<Parser>()) {}
QueryReader::~QueryReader() = default;

std::size_t QueryReader::read_fields(std::string_view line, Query& query) {
    if (line.size() > longest_line) {
        throw MalformedQuery(fmt::format("a line may have {} MiB at most", longest_line >> 20U));
    }
    for_each_kind([](Subject /*kind*/, auto& of_kind) { of_kind.clear(); }, query.objects);
    json::element root;
    auto error = parser_->json.parse(line.data(), line.size()).get(root);
    if (error == simdjson::NUMBER_ERROR) error = parser_->json.parse(with_exponents(line)).get(root);
    if (error) throw MalformedQuery(simdjson::error_message(error));
    json::object fields;
    if (root.get(fields) != simdjson::SUCCESS) throw MalformedQuery("a query must be an object");
    std::array<std::string_view, 2 + std::size(objects)> met;
    std::size_t count = 0;
    const auto has = [&](std::string_view name) { return std::count(met.begin(), met.begin() + count, name) > 0; };
    for (const auto& [name, value] : fields) {
        if (has(name)) throw MalformedQuery(fmt::format("\"{}\" is there twice", name));
        read_value(name, value, query);
        met.at(count++) = name;
    }
    if (!has("origin") || !has("direction")) {
        throw MalformedQuery("a query must have an origin and a direction");
    }
    return count;
}

void QueryReader::read(std::string_view line, Query& query) {
    read_fields(line, query);
}

kernel::Ray<double> QueryReader::read_ray(std::string_view line) {
    if (read_fields(line, ray_alone_) != 2) {
        throw MalformedQuery("a query to a scene has an origin and a direction alone; the objects are the scene's");
    }
    return ray_alone_.ray;
}

}  // namespace reference::cast
