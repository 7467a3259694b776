// None: that GLM_ENABLE_EXPERIMENTAL is defined twice is warned of in any case.
#define GLM_ENABLE_EXPERIMENTAL 1
#include <cstdio>
#include <glm/gtx/string_cast.hpp>
int main() { std::puts(glm::to_string(glm::vec3(1)).c_str()); }
