// Objects are made and named the same, in the same order.
#include <iostream>
#include <string>
#include <vector>
namespace {
const std::string hidden = "hidden";
std::vector<int> numbers{1, 2, 3};
auto lambda = [](int i) { return numbers[static_cast<std::size_t>(i)]; };
}  // namespace
int main() { std::cout << hidden << lambda(1) << [] { return 4; }() << '\n'; }
