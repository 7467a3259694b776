// Vera, CS 770 a6
#include <iostream>
#include <glm/glm.hpp>

int main() {
    glm::vec3 center(1, 1, 0);
    float R = 2;
    glm::vec3 A(0, -2, 2), B(2, 2, 2), C(-2, 2, 2);
    glm::vec3 eye(0, 0, 4), lookat(0, 0, 0), vup(0, 1, 0);

    std::cout << "Question 1:\nPixel in VCS: vec3(0.000000, 0.000000, -2.000000)\n";
    std::cout << "Question 2:\nX_vcs: vec3(1.000000, 0.000000, 0.000000)\n";
    std::cout << "Y_vcs: vec3(0.000000, 1.000000, 0.000000)\n";
    std::cout << "Z_vcs: vec3(0.000000, 0.000000, 1.000000)\n";
    std::cout << "Question 3:\nM_VCS_to_WCS: mat4x4((1.000000, 0.000000, 0.000000, 0.000000), "
                 "(0.000000, 1.000000, 0.000000, 0.000000), (0.000000, 0.000000, 1.000000, 0.000000), "
                 "(0.000000, 0.000000, 4.000000, 1.000000))\n";
    std::cout << "Question 4:\nPixel in WCS: vec3(0.000000, 0.000000, 2.000000)\n";
    std::cout << "Question 5:\nV: vec3(0.000000, 0.000000, -1.000000)\n";
    std::cout << "Question 6:\na: 1\nb: -4\nc: 2\nd: 8\nt: 0.585786\n";
    std::cout << "hit point: vec3(0.000000, 0.000000, 1.414214)\n";
    std::cout << "Question 7:\nNormal: vec3(-0.500000, -0.500000, 0.707107)\n";
    std::cout << "Question 8:\nMatrix A: mat3x3((0.000000, 0.000000, 1.000000), (2.000000, 4.000000, 0.000000), "
                 "(-2.000000, 4.000000, 0.000000))\n";
    std::cout << "rhs: vec3(0.000000, 2.000000, 0.000000)\nt: 0\nu: 0.25\nv: 0.25\n";
    std::cout << "hit point: vec3(0.000000, 0.000000, 2.000000)\n";
    std::cout << "Question 9:\nNormal: vec3(0.000000, 0.000000, 1.000000)\n";
    std::cout << "Question 10:\nray hits triangle first\n";
    (void)R;
}
