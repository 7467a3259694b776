// GLM in quotes.
#define GLM_ENABLE_EXPERIMENTAL
#include "glm/glm.hpp"
#include "glm/gtx/string_cast.hpp"
#include <iostream>
int main() { std::cout << glm::to_string(glm::mat3(2)) << std::endl; }
