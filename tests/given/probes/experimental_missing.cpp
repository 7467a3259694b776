// None: the flags allow what GLM calls experimental.
#include <cstdio>
#include <glm/gtx/string_cast.hpp>
int main() { std::puts(glm::to_string(glm::vec3(1)).c_str()); }
