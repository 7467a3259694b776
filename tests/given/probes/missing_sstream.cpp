// A bundle supplies the <sstream> that is missing: this does not compile.
#include <iostream>
#include <string>
int main() {
    std::ostringstream text;
    text << 1;
    std::cout << text.str() << '\n';
}
