// A bundle may have used the template before it is specialised.
#include <functional>
#include <glm/glm.hpp>
#include <iostream>
namespace std {
template <>
struct hash<glm::vec3> {
    size_t operator()(const glm::vec3& v) const { return static_cast<size_t>(v.x + v.y); }
};
}  // namespace std
int main() { std::cout << std::hash<glm::vec3>()(glm::vec3(2)) << '\n'; }
