#include "reference/cast/queries.h"

#include <fmt/format.h>

#include <memory>

#include "reference/cast/query.h"
#include "reference/cast/text.h"

namespace reference::cast {
namespace {

using cast::append;

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
    append(text, R"(,"part":")");
    append(text, name_of(cylinder.part));
    append(text, "\"}");
}

template <class Hit>
void append(Text& text, const std::vector<Hit>& hits) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        if (i > 0) append(text, ",");
        append(text, hits[i]);
    }
}

void append(Text& text, const kernel::First& first) {
    if (!first.object) return append(text, "invalid");
    if (first.object == FirstObject::tie) return append(text, "tie");
    if (first.object == FirstObject::no_hit) return append(text, "none");
    fmt::format_to(fmt::appender(text), "{} {}", to_string(*first.object->kind()), first.index);
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

}  // namespace

long answer_queries(std::istream& queries, std::ostream& answers, int jobs) {
    LineBlocks blocks(queries);
    const auto new_worker = [] {
        return [reader = std::make_shared<QueryReader>(), query = Query(), cast = kernel::Cast()](const Block& block,
                                                                                                  Text& text) mutable {
            long malformed = 0;
            for_each_line(block, [&](std::string_view line, std::uint64_t number) {
                try {
                    reader->read(line, query);
                    kernel::cast_ray(query.ray, query.objects, cast);
                    append(text, cast);
                } catch (const MalformedQuery& error) {
                    ++malformed;
                    append_error(text, error.what(), number);
                }
            });
            return malformed;
        };
    };
    return answer_in_order([&](Block& block) { return blocks.next(block); }, new_worker, answers, jobs);
}

}  // namespace reference::cast
