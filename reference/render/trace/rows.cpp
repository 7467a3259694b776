#include "reference/render/trace/rows.h"

namespace reference::render {

template <bool has_cylinders>
struct ListOfObjects;
struct ObjectTree;
// Compiled in rows_of_list.cpp and rows_of_tree.cpp.
template <class Objects>
RenderRow row_renderer_over(const Effects& effects);

RayCounts& RayCounts::operator+=(const RayCounts& other) {
    shadow += other.shadow;
    mirrored += other.mirrored;
    refracted += other.refracted;
    reflected_in_glass += other.reflected_in_glass;
    return *this;
}

RenderRow row_renderer(const PreparedScene& scene, const Effects& effects) {
    return scene.tree ? row_renderer_over<ObjectTree>(effects) : row_renderer_over<ListOfObjects<false>>(effects);
}

}  // namespace reference::render
