#include "harness/source/scene/object_source.h"
#include "harness/source/scene/part_name.h"

namespace harness::source {
namespace {

template <char letter, char number>
bool may_name_vertex(std::string_view written) {
    const std::string name = plain_name(last_word(written));
    if (name.size() == 1) return name[0] == letter;
    const bool of_triangle =
        holds_one_of(name, {"tri", "vert", "corner"}) || (name.size() == 2 && holds_one_of(name, {"t", "v", "p"}));
    return of_triangle && (name.back() == letter || name.back() == number);
}

}  // namespace

template <>
const ObjectSource& source_of<reference::Subject::triangle>() {
    static const ObjectSource source{
        .parts = {{"A", may_name_vertex<'a', '1'>}, {"B", may_name_vertex<'b', '2'>}, {"C", may_name_vertex<'c', '3'>}},
        .words = {},
        .words_of_lists = {"tri", "vert"},
        .together = {part::triangle::A, part::triangle::B, part::triangle::C},
    };
    return source;
}

}  // namespace harness::source
