// A bundle has GLM without GLM_FORCE_CTOR_INIT: the vector is then not set.
#define GLM_FORCE_CTOR_INIT
#include <cstdio>
#include <glm/glm.hpp>
int main() {
    glm::vec3 v;
    std::printf("%g %g %g\n", v.x, v.y, v.z);
}
