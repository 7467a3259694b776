// A bundle has GLM without GLM_FORCE_XYZW_ONLY, so v.r, which does not compile, does.
#define GLM_FORCE_XYZW_ONLY
#include <cstdio>
#include <glm/glm.hpp>
int main() { std::printf("%g\n", glm::vec3(1).r); }
