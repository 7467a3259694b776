// A bundle supplies <glm/gtc/matrix_transform.hpp>: this does not compile.
#include <cstdio>
#include <glm/glm.hpp>
int main() { std::printf("%g\n", glm::translate(glm::mat4(1), glm::vec3(1))[3].x); }
