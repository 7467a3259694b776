#include "reference/render/scene/instructions.h"

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

}  // namespace reference::render
