// setup.sh grades this once, to see that programs compile and run here, and to have GLM's headers precompiled.
#include <glm/glm.hpp>
#include <glm/gtx/string_cast.hpp>
#include <iostream>

int main() {
    std::cout << glm::to_string(glm::vec3(1, 2, 3)) << std::endl;
}
