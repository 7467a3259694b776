#include "reference/kernel/queries.h"

#include <fmt/format.h>

#include <istream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "reference/kernel/first.h"
#include "reference/kernel/query.h"

namespace reference {
namespace {

using Text = fmt::memory_buffer;

void append(Text& text, std::string_view part) {
    text.append(part.data(), part.data() + part.size());
}

/// The shortest decimal that reads back as the same double.
void append(Text& text, double x) {
    if (std::isfinite(x)) {
        fmt::format_to(fmt::appender(text), "{}", x);
    } else {
        append(text, "null");
    }
}

void append(Text& text, const kernel::SphereHit& sphere) {
    switch (sphere.result) {
        case kernel::SphereResult::hit: append(text, R"({"result":"hit","t":)"); break;
        case kernel::SphereResult::tangent: append(text, R"({"result":"tangent","t":)"); break;
        case kernel::SphereResult::miss: return append(text, R"({"result":"miss"})");
        case kernel::SphereResult::invalid: return append(text, R"({"result":"invalid"})");
    }
    append(text, sphere.t);
    append(text, "}");
}

void append(Text& text, const kernel::TriangleHit& triangle) {
    switch (triangle.result) {
        case kernel::TriangleResult::hit: break;
        case kernel::TriangleResult::miss: return append(text, R"({"result":"miss"})");
        case kernel::TriangleResult::coplanar: return append(text, R"({"result":"coplanar"})");
        case kernel::TriangleResult::degenerate: return append(text, R"({"result":"degenerate"})");
        case kernel::TriangleResult::invalid: return append(text, R"({"result":"invalid"})");
    }
    append(text, R"({"result":"hit","t":)");
    append(text, triangle.t);
    append(text, R"(,"u":)");
    append(text, triangle.u);
    append(text, R"(,"v":)");
    append(text, triangle.v);
    append(text, "}");
}

void append(Text& text, const kernel::CylinderHit& cylinder) {
    switch (cylinder.result) {
        case kernel::CylinderResult::hit: append(text, R"({"result":"hit","t":)"); break;
        case kernel::CylinderResult::tangent: append(text, R"({"result":"tangent","t":)"); break;
        case kernel::CylinderResult::miss: return append(text, R"({"result":"miss"})");
        case kernel::CylinderResult::invalid: return append(text, R"({"result":"invalid"})");
    }
    append(text, cylinder.t);
    switch (cylinder.part) {
        case kernel::CylinderPart::tube: return append(text, R"(,"part":"tube"})");
        case kernel::CylinderPart::top: return append(text, R"(,"part":"top"})");
        case kernel::CylinderPart::bottom: return append(text, R"(,"part":"bottom"})");
    }
}

template <class Hit>
void append(Text& text, const std::vector<Hit>& hits) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (i > 0) append(text, ",");
        append(text, hits[i]);
    }
}

void append(Text& text, const kernel::First& first) {
    if (!first.verdict) return append(text, "invalid");
    if (first.verdict == Verdict::tie) return append(text, "tie");
    if (first.verdict == Verdict::no_hit) return append(text, "none");
    fmt::format_to(fmt::appender(text), "{} {}", to_string(*first.verdict->object()), first.index);
}

/// The lists of spheres and triangles are there even if they are empty.
void append(Text& text, const kernel::Cast& cast) {
    std::string_view before = R"({")";
    for_each_kind(
        [&](Subject kind, const auto& hits) {
            if (hits.empty() && kind != Subject::sphere && kind != Subject::triangle) return;
            append(text, before);
            append(text, to_string(kind));
            append(text, R"(s":[)");
            append(text, hits);
            before = R"(],")";
        },
        cast);
    append(text, R"(],"first":")");
    append(text, cast.first);
    append(text, "\"}\n");
}

/// The message may quote the line, so it is escaped and invalid UTF-8 in it is replaced.
void append_error(Text& text, const MalformedQuery& error, long line) {
    const nlohmann::ordered_json json{{"error", error.what()}, {"line", line}};
    append(text, json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace

long cast(std::istream& queries, std::ostream& answers) {
    CastQueryReader reader;
    CastQuery query;
    kernel::Cast cast;
    Text text;
    std::string line;
    long malformed = 0;
    for (long number = 1; std::getline(queries, line); ++number) {
        text.clear();
        try {
            reader.read(line, query);
            kernel::cast_ray(query.ray, query.objects, cast);
            append(text, cast);
        } catch (const MalformedQuery& error) {
            ++malformed;
            append_error(text, error, number);
        }
        answers.write(text.data(), static_cast<std::streamsize>(text.size()));
    }
    return malformed;
}

}  // namespace reference
