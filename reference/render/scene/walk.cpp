#include "reference/render/scene/walk.h"

#include "reference/render/scene/walk_body.h"

namespace reference::render {

bool walk(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until, Visitor& visitor) {
#ifdef __x86_64__
    if (tree.instructions == Instructions::avx2) return walk_avx2(tree, ray, uncertainty, until, visitor);
#endif
    return walk_portable(tree, ray, uncertainty, until, visitor);
}

}  // namespace reference::render
