// A bundle has GLM without GLM_FORCE_EXPLICIT_CTOR: a conversion that does not compile does.
#define GLM_FORCE_EXPLICIT_CTOR
#include <cstdio>
#include <glm/glm.hpp>
int main() {
    const glm::ivec3 v = glm::vec3(1.5f);
    std::printf("%d\n", v.x);
}
