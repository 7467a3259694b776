#include "reference/kernel/query.h"

#include <fmt/format.h>
#include <simdjson.h>

#include <charconv>
#include <limits>

namespace reference {
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

Sphere<double> sphere(const json::element& element) {
    json::object fields;
    if (element.get(fields) != simdjson::SUCCESS) throw MalformedQuery("a sphere must be an object");
    std::optional<Vec3<double>> center;
    std::optional<double> radius;
    for (const auto& [key, value] : fields) {
        if (key == "center" && !center) {
            center = point(value, "center");
        } else if (key == "radius" && !radius) {
            radius = number(value, "radius");
        } else {
            throw MalformedQuery(
                fmt::format("a sphere has one center and one radius; \"{}\" is neither or double", key));
        }
    }
    if (!center || !radius) throw MalformedQuery("a sphere must have a center and a radius");
    return {*center, *radius};
}

Cylinder<double> cylinder(const json::element& element) {
    json::object fields;
    if (element.get(fields) != simdjson::SUCCESS) throw MalformedQuery("a cylinder must be an object");
    std::optional<Vec3<double>> center;
    std::optional<double> radius;
    std::optional<double> height;
    for (const auto& [key, value] : fields) {
        if (key == "center" && !center) {
            center = point(value, "center");
        } else if (key == "radius" && !radius) {
            radius = number(value, "radius");
        } else if (key == "height" && !height) {
            height = number(value, "height");
        } else {
            throw MalformedQuery(
                fmt::format("a cylinder has one center, one radius and one height; \"{}\" is none or double", key));
        }
    }
    if (!center || !radius || !height) {
        throw MalformedQuery("a cylinder must have a center, a radius and a height");
    }
    return {*center, *radius, *height};
}

Triangle<double> triangle(const json::element& element) {
    const json::array vertices = array(element, "a triangle");
    if (vertices.size() != 3) throw MalformedQuery("a triangle must have three vertices");
    auto vertex = vertices.begin();
    const auto next = [&] {
        const Vec3<double> p = point(*vertex, "a vertex");
        ++vertex;
        return p;
    };
    const Vec3<double> A = next();
    const Vec3<double> B = next();
    return {A, B, next()};
}

/// The keys of a query that were already read; each may occur once.
enum Key : unsigned { origin = 1, direction = 2, spheres = 4, triangles = 8, cylinders = 16 };

Key key_of(std::string_view name) {
    if (name == "origin") return origin;
    if (name == "direction") return direction;
    if (name == "spheres") return spheres;
    if (name == "triangles") return triangles;
    if (name == "cylinders") return cylinders;
    throw MalformedQuery(
        fmt::format("\"{}\" is not a key; there are origin, direction, spheres, triangles and cylinders", name));
}

void read_value(Key key, const json::element& value, CastQuery& query) {
    kernel::Objects& objects = query.objects;
    switch (key) {
        case origin: query.ray.origin = point(value, "origin"); break;
        case direction: query.ray.direction = point(value, "direction"); break;
        case spheres:
            for (const json::element& element : array(value, "spheres")) objects.spheres.push_back(sphere(element));
            break;
        case triangles:
            for (const json::element& element : array(value, "triangles"))
                objects.triangles.push_back(triangle(element));
            break;
        case cylinders:
            for (const json::element& element : array(value, "cylinders"))
                objects.cylinders.push_back(cylinder(element));
            break;
    }
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

struct CastQueryReader::Parser {
    json::parser json;
};

CastQueryReader::CastQueryReader() : parser_(std::make_unique<Parser>()) {}
CastQueryReader::~CastQueryReader() = default;

void CastQueryReader::read(const std::string& line, CastQuery& query) {
    query.objects.spheres.clear();
    query.objects.triangles.clear();
    query.objects.cylinders.clear();
    json::element root;
    auto error = parser_->json.parse(line).get(root);
    if (error == simdjson::NUMBER_ERROR) error = parser_->json.parse(with_exponents(line)).get(root);
    if (error) throw MalformedQuery(simdjson::error_message(error));
    json::object fields;
    if (root.get(fields) != simdjson::SUCCESS) throw MalformedQuery("a query must be an object");
    unsigned met = 0;
    for (const auto& [name, value] : fields) {
        const Key key = key_of(name);
        if ((met & key) != 0) throw MalformedQuery(fmt::format("\"{}\" is there twice", name));
        met |= key;
        read_value(key, value, query);
    }
    if ((met & origin) == 0 || (met & direction) == 0) {
        throw MalformedQuery("a query must have an origin and a direction");
    }
}

}  // namespace reference
