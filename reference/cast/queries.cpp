#include "reference/cast/queries.h"

#include <fmt/format.h>

#include <cmath>
#include <istream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "reference/cast/query.h"

namespace reference::cast {
namespace {

/// The shortest decimal that reads back as the same double; null for one that is not finite.
std::string text_of(double x) {
    return std::isfinite(x) ? fmt::to_string(x) : "null";
}

std::string_view name_of(kernel::SphereResult result) {
    switch (result) {
        case kernel::SphereResult::hit: return "hit";
        case kernel::SphereResult::miss: return "miss";
        case kernel::SphereResult::tangent: return "tangent";
        case kernel::SphereResult::invalid: break;
    }
    return "invalid";
}
std::string_view name_of(kernel::TriangleResult result) {
    switch (result) {
        case kernel::TriangleResult::hit: return "hit";
        case kernel::TriangleResult::miss: return "miss";
        case kernel::TriangleResult::coplanar: return "coplanar";
        case kernel::TriangleResult::degenerate: return "degenerate";
        case kernel::TriangleResult::invalid: break;
    }
    return "invalid";
}
std::string_view name_of(kernel::CylinderResult result) {
    switch (result) {
        case kernel::CylinderResult::hit: return "hit";
        case kernel::CylinderResult::miss: return "miss";
        case kernel::CylinderResult::tangent: return "tangent";
        case kernel::CylinderResult::invalid: break;
    }
    return "invalid";
}
std::string_view name_of(kernel::CylinderPart part) {
    switch (part) {
        case kernel::CylinderPart::tube: return "tube";
        case kernel::CylinderPart::top: return "top";
        case kernel::CylinderPart::bottom: break;
    }
    return "bottom";
}

// What an entry says beside t.
std::string further(const kernel::SphereHit& /*hit*/) {
    return "";
}
std::string further(const kernel::TriangleHit& hit) {
    return fmt::format(R"(,"u":{},"v":{})", text_of(hit.u), text_of(hit.v));
}
std::string further(const kernel::CylinderHit& hit) {
    return fmt::format(R"(,"part":"{}")", name_of(hit.part));
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

/// The lists of spheres and triangles are there even if they are empty.
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
    const nlohmann::ordered_json json{{"error", message}, {"line", line}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
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
        // A program that sends a query and waits gets its answer.
        if (queries.rdbuf()->in_avail() <= 0) answers.flush();
    }
    answers.flush();
    return malformed;
}

}  // namespace reference::cast
