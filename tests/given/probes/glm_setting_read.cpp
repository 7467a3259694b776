// A bundle has GLM's settings at their defaults.
#define GLM_FORCE_INLINE
#define GLM_FORCE_SIZE_T_LENGTH
#include <cstdio>
#include <glm/glm.hpp>
int main() { std::printf("%d\n", static_cast<int>(sizeof(glm::vec3(1).length()))); }
