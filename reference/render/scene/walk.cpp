#include "reference/render/scene/walk.h"

#include "reference/render/scene/walk_body.h"

namespace reference::render {

std::vector<Instructions> all_instructions() {
    std::vector<Instructions> all{Instructions::portable};
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) all.push_back(Instructions::avx2);
#endif
    return all;
}

Instructions best_instructions() {
    return all_instructions().back();
}

bool walk(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until, Visitor& visitor) {
#ifdef __x86_64__
    if (tree.instructions == Instructions::avx2) return walk_avx2(tree, ray, uncertainty, until, visitor);
#endif
    return walk_portable(tree, ray, uncertainty, until, visitor);
}

}  // namespace reference::render
