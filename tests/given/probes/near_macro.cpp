// In a bundle, near is no macro yet.
#define near 2.0f
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
static void show(const glm::mat4& m) {
    for (int i = 0; i < 4; ++i) std::printf("%g %g %g %g\n", m[i].x, m[i].y, m[i].z, m[i].w);
}
int main() { show(glm::perspective(1.0f, 1.5f, near, 9.0f)); }
