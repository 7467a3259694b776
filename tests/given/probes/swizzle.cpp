// A bundle has GLM without GLM_FORCE_SWIZZLE: v.zyx() is then unknown.
#define GLM_FORCE_SWIZZLE
#include <cstdio>
#include <glm/glm.hpp>
int main() {
    const glm::vec3 v(1, 2, 3);
    const glm::vec3 w = v.zyx();
    std::printf("%g %g %g\n", w.x, w.y, w.z);
}
