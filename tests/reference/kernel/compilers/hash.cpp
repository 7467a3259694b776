// hash CASES: prints the decisions on as many narrow cases as a number, the same whatever compiler and flags made this
// program. If the arithmetic is unfit, it says instead for what.
#include <cstdio>
#include <cstdlib>

#include "reference/kernel/self_test.h"

int main(int argc, char** argv) {
    const std::uint64_t cases = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000;
    const std::string trouble = reference::kernel::arithmetic_trouble();
    if (!trouble.empty()) {
        std::printf("%s\n", trouble.c_str());
        return 1;
    }
    std::printf("%016llx\n", static_cast<unsigned long long>(reference::kernel::hash_of_decisions(cases)));
}
