// setup.sh grades this program once, to check that programs compile and run here, and to precompile GLM's headers.
#include <glm/glm.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

int main() {
    std::cout << glm::to_string(glm::vec3(1, 2, 3)) << std::endl;
}
