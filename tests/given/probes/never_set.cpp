// Warnings that need the optimiser are the same.
#include <glm/glm.hpp>
#include <iostream>
int main() {
    glm::vec3 n;
    std::cout << (n.x == n.x ? 1 : 2) << '\n';
}
