// A bundle has GLM without GLM_FORCE_LEFT_HANDED: another matrix, without a word.
#define GLM_FORCE_LEFT_HANDED
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
static void show(const glm::mat4& m) {
    for (int i = 0; i < 4; ++i) std::printf("%g %g %g %g\n", m[i].x, m[i].y, m[i].z, m[i].w);
}
int main() { show(glm::lookAt(glm::vec3(0, 0, 4), glm::vec3(0), glm::vec3(0, 1, 0))); }
