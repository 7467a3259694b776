// hash CASES: prints the decisions on as many narrow cases as two numbers, the same whatever compiler and flags made
// this program: those on spheres and triangles, and those on cylinders as well. If the arithmetic is unfit, it says
// instead for what. Compiled with WITHOUT_LIBRARIES, it prints the first number only: no case of these is so large that
// its decision calls a library.
#include <cstdio>
#include <cstdlib>

#include "reference/kernel/self_test.h"
#include "reference/kernel/sphere.h"
#include "reference/kernel/triangle.h"

namespace {

std::uint64_t hash_without_cylinders(std::uint64_t cases) {
    std::uint64_t hash = reference::kernel::no_decision;
    for (std::uint64_t seed = 0; seed < cases; ++seed) {
        const auto narrow = reference::kernel::narrow_case(seed);
        hash = reference::kernel::hashed(hash, static_cast<int>(decide(narrow.ray, narrow.sphere)));
        hash = reference::kernel::hashed(hash, static_cast<int>(decide(narrow.ray, narrow.triangle)));
    }
    return hash;
}

void print(const char* format, std::uint64_t hash) {
    std::printf(format, static_cast<unsigned long long>(hash));
}

}  // namespace

int main(int argc, char** argv) {
    const std::uint64_t cases = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000;
#ifndef WITHOUT_LIBRARIES
    const std::string trouble = reference::kernel::arithmetic_trouble();
    if (!trouble.empty()) {
        std::printf("%s\n", trouble.c_str());
        return 1;
    }
#endif
    print("%016llx", hash_without_cylinders(cases));
#ifndef WITHOUT_LIBRARIES
    print(" %016llx", reference::kernel::hash_of_decisions(cases));
#endif
    std::printf("\n");
}
