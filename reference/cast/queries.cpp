#include "reference/cast/queries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <stdexcept>

#include "reference/kernel/first.h"

namespace reference::cast {
namespace {

using nlohmann::ordered_json;

struct Query {
    kernel::Ray<double> ray;
    kernel::Objects objects;
};

/// The line is not a valid query; what() says why.
class MalformedQuery : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

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

template <class Object>
void read_object(const ordered_json& value, std::string_view kind, Object& object) {
    if (!value.is_object()) throw MalformedQuery(fmt::format("a {} must be an object", kind));
    const std::vector<std::string_view> names = field_names<Object>();
    for_each_field(
        [&](std::string_view name, auto& field) {
            if (!value.contains(name)) throw MalformedQuery(fmt::format("a {} must have a {}", kind, name));
            read_field(field, value[name], name);
        },
        object);
    if (value.size() != names.size())
        throw MalformedQuery(fmt::format("a {} has only these keys: {}", kind, fmt::join(names, ", ")));
}

/// A triangle is the list of its vertices.
void read_object(const ordered_json& value, std::string_view /*kind*/, Triangle<double>& triangle) {
    if (array(value, "a triangle").size() != 3) throw MalformedQuery("a triangle must have three vertices");
    read_field(triangle.A, value[0], "a vertex");
    read_field(triangle.B, value[1], "a vertex");
    read_field(triangle.C, value[2], "a vertex");
}

void read_value(const std::string& key, const ordered_json& value, Query& query) {
    if (key == "origin") return read_field(query.ray.origin, value, key);
    if (key == "direction") return read_field(query.ray.direction, value, key);
    std::string known = "origin, direction";
    bool is_known = false;
    for_each_kind(
        [&](Subject kind, auto& of_kind) {
            known += fmt::format(", {}s", to_string(kind));
            if (key != fmt::format("{}s", to_string(kind))) return;
            is_known = true;
            for (const ordered_json& object : array(value, key)) {
                read_object(object, to_string(kind), of_kind.emplace_back());
            }
        },
        query.objects);
    if (!is_known) throw MalformedQuery(fmt::format("\"{}\" is not a key; there are {}", key, known));
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

/// The shortest decimal that reads back as the same double; null for one that is not finite.
std::string text_of(double x) {
    return std::isfinite(x) ? fmt::to_string(x) : "null";
}

const char* name_of(kernel::SphereResult result) {
    return std::array{"hit", "miss", "tangent", "invalid"}.at(static_cast<std::size_t>(result));
}
const char* name_of(kernel::TriangleResult result) {
    return std::array{"hit", "miss", "coplanar", "degenerate", "invalid"}.at(static_cast<std::size_t>(result));
}

// The fields of an entry other than t.
std::string further(const kernel::SphereHit& /*hit*/) {
    return "";
}
std::string further(const kernel::TriangleHit& hit) {
    return fmt::format(R"(,"u":{},"v":{})", text_of(hit.u), text_of(hit.v));
}
std::string further(const kernel::CylinderHit& hit) {
    const bool is_top = hit.part == kernel::CylinderPart::top;
    return fmt::format(R"(,"part":"{}")", is_top ? "top" : hit.part == kernel::CylinderPart::tube ? "tube" : "bottom");
}

template <class Hit>
std::string text_of(const Hit& hit) {
    const std::string values = is_hit(hit.result) ? fmt::format(R"(,"t":{}{})", text_of(hit.t), further(hit)) : "";
    return fmt::format(R"({{"result":"{}"{}}})", name_of(hit.result), values);
}

std::string text_of(const kernel::First& first) {
    if (!first.object) return "invalid";
    if (first.object == FirstObject::tie) return "tie";
    if (first.object == FirstObject::no_hit) return "none";
    return fmt::format("{} {}", to_string(*first.object->kind()), first.index);
}

/// The lists of spheres and triangles are written even if they are empty.
std::string text_of(const kernel::Cast& cast) {
    std::string text = "{";
    for_each_kind(
        [&](Subject kind, const auto& hits) {
            if (hits.empty() && kind != Subject::sphere && kind != Subject::triangle) return;
            text += fmt::format(R"("{}s":[)", to_string(kind));
            for (std::size_t i = 0; i < hits.size(); ++i) text += (i > 0 ? "," : "") + text_of(hits[i]);
            text += "],";
        },
        cast);
    return text + fmt::format(R"("first":"{}"}})", text_of(cast.first));
}

/// The message may quote the line, so it is escaped and invalid UTF-8 in it is replaced.
std::string error_text(std::string_view message, long line) {
    const ordered_json json{{"error", message}, {"line", line}};
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

long answer_queries(std::istream& queries, std::ostream& answers) {
    long malformed = 0;
    long number = 0;
    kernel::Cast cast;
    for (std::string line; answers && std::getline(queries, line);) {
        ++number;
        try {
            const Query query = read_query(line);
            kernel::cast_ray(query.ray, query.objects, cast);
            answers << text_of(cast) << '\n';
        } catch (const MalformedQuery& error) {
            ++malformed;
            answers << error_text(error.what(), number) << '\n';
        }
        // A program that sends a query and waits must get its answer.
        if (queries.rdbuf()->in_avail() <= 0) answers.flush();
    }
    answers.flush();
    return malformed;
}

}  // namespace reference::cast
