// hash CASES: prints the decisions on as many narrow cases as one number, the same whatever compiler and flags made
// this program. Compiled with RAYGRADE_TROUBLE, it says instead what its arithmetic is unfit for.
#include <cstdio>
#include <cstdlib>

#include "reference/kernel/self_test.h"

int main(int argc, char** argv) {
    const std::string trouble = reference::kernel::arithmetic_trouble();
    if (!trouble.empty()) {
        std::printf("%s\n", trouble.c_str());
        return 1;
    }
    const std::uint64_t cases = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000;
    std::printf("%016llx\n", static_cast<unsigned long long>(reference::kernel::hash_of_decisions(cases)));
}
