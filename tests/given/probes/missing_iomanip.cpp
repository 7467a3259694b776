// A bundle supplies the <iomanip> that is missing: this does not compile.
#include <iostream>
int main() { std::cout << std::setprecision(3) << 3.14159 << '\n'; }
