#include "reference/cast/scene_queries.h"

#include <bit>
#include <memory>

#include "reference/cast/query.h"
#include "reference/cast/text.h"

namespace reference::cast {
namespace {

using cast::append;
using cast::name_of;

std::string_view name_of(FirstHit::Kind kind) {
    switch (kind) {
        case FirstHit::Kind::none: return "none";
        case FirstHit::Kind::sphere: return "sphere";
        case FirstHit::Kind::triangle: return "triangle";
        case FirstHit::Kind::mesh: return "mesh";
        case FirstHit::Kind::cylinder: return "cylinder";
        case FirstHit::Kind::invalid: break;
    }
    return "invalid";
}

void append_uv(Text& text, const FirstHit& hit) {
    append(text, R"(,"u":)");
    append(text, hit.u);
    append(text, R"(,"v":)");
    append(text, hit.v);
}

/// What only some kinds have.
void append_rest(Text& text, const FirstHit& hit) {
    switch (hit.kind) {
        case FirstHit::Kind::triangle:
        case FirstHit::Kind::mesh: return append_uv(text, hit);
        case FirstHit::Kind::cylinder:
            append(text, R"(,"part":")");
            append(text, name_of(hit.part));
            return append(text, "\"");
        case FirstHit::Kind::none:
        case FirstHit::Kind::sphere:
        case FirstHit::Kind::invalid: return;
    }
}

void append(Text& text, const FirstHit& hit) {
    append(text, R"({"first":")");
    append(text, name_of(hit.kind));
    if (hit.kind == FirstHit::Kind::none || hit.kind == FirstHit::Kind::invalid) return append(text, "\"}\n");
    append(text, " ");
    append(text, hit.index);
    append(text, "\"");
    if (hit.kind == FirstHit::Kind::mesh) {
        append(text, R"(,"face":)");
        append(text, hit.face);
    }
    if (hit.is_tie) append(text, R"(,"tie":true)");
    append(text, R"(,"t":)");
    append(text, hit.t);
    append_rest(text, hit);
    append(text, "}\n");
}

/// The least significant byte first, on every machine.
template <class Whole>
void append_bytes(Text& text, Whole x) {
    for (std::size_t i = 0; i < sizeof x; ++i) text.push_back(static_cast<char>(x >> (8 * i) & 0xffU));
}

double double_at(std::string_view bytes, std::size_t place) {
    std::uint64_t x = 0;
    for (std::size_t i = 0; i < sizeof x; ++i) {
        x |= std::uint64_t{static_cast<unsigned char>(bytes[8 * place + i])} << (8 * i);
    }
    return std::bit_cast<double>(x);
}

void append_record(Text& text, const FirstHit& hit) {
    append_bytes(text, static_cast<std::uint32_t>(hit.kind));
    append_bytes(text, hit.index);
    append_bytes(text, hit.face);
    append_bytes(text, static_cast<std::uint8_t>(hit.part));
    append_bytes(text, static_cast<std::uint8_t>(hit.is_tie));
    append_bytes(text, std::uint16_t{0});
    for (const double x : {hit.t, hit.u, hit.v}) append_bytes(text, std::bit_cast<std::uint64_t>(x));
}

}  // namespace

long answer_lines(const render::PreparedScene& scene, std::istream& rays, std::ostream& answers, int jobs) {
    LineBlocks blocks(rays);
    const auto new_worker = [&scene] {
        return [&scene, reader = std::make_shared<QueryReader>()](const Block& block, Text& text) {
            long malformed = 0;
            for_each_line(block, [&](std::string_view line, std::uint64_t number) {
                try {
                    append(text, first_hit(scene, reader->read_ray(line)));
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

RecordsRead answer_records(const render::PreparedScene& scene, std::istream& rays, std::ostream& answers, int jobs) {
    RecordBlocks blocks(rays, ray_bytes);
    const auto new_worker = [&scene] {
        return [&scene](const Block& block, Text& text) {
            for (std::string_view rest = block.bytes; !rest.empty(); rest.remove_prefix(ray_bytes)) {
                const auto point = [&](std::size_t place) {
                    return Vec3<double>(double_at(rest, place), double_at(rest, place + 1), double_at(rest, place + 2));
                };
                append_record(text, first_hit(scene, {point(0), point(3)}));
            }
            return 0;
        };
    };
    answer_in_order([&](Block& block) { return blocks.next(block); }, new_worker, answers, jobs);
    return {blocks.records(), blocks.left_over()};
}

}  // namespace reference::cast
