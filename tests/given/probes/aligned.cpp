// A bundle has GLM without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES: another size.
#define GLM_FORCE_INTRINSICS
#define GLM_FORCE_DEFAULT_ALIGNED_GENTYPES
#include <cstdio>
#include <glm/glm.hpp>
int main() { std::printf("%d\n", static_cast<int>(sizeof(glm::vec3))); }
