#include "harness/source/scene/object_source.h"
#include "harness/source/scene/part_name.h"

namespace harness::source {
namespace {

bool may_name_sphere_center(std::string_view name) {
    const std::string word = plain_name(last_word(name));
    return holds_one_of(word, {"cen", "sph", "ball", "circle"}) || is_one_of(word, {"c", "sc", "cs", "o"});
}

bool may_name_sphere_radius(std::string_view name) {
    const std::string_view written = last_word(name);
    return may_name_radius(written, plain_name(written));
}

}  // namespace

template <>
const ObjectSource& source_of<reference::Subject::sphere>() {
    static const ObjectSource source{
        .parts = {{"center", may_name_sphere_center}, {"radius", may_name_sphere_radius, true}},
        .words = {"sph", "ball"},
    };
    return source;
}

}  // namespace harness::source
