// A bundle's GLM is not packed.
#pragma pack(1)
#include <cstdio>
#include <glm/glm.hpp>
struct Hit {
    char what;
    glm::vec3 where;
};
int main() { std::printf("%d\n", static_cast<int>(sizeof(Hit))); }
