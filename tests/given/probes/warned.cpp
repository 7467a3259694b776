// The messages are those of the plain way, with its lines.
#include <cstdio>
#include <glm/glm.hpp>
static int unused_function() { return 1; }
int main() {
    int unused;
    glm::vec3 n;
    std::printf("%d\n", n.x > 1);
}
