// hash CASES: prints the decisions on as many narrow cases as a number, the same whatever compiler and flags made this
// program. If the arithmetic is unfit, or a hard case of the catalog comes out wrong, it says that instead.
#include <cstdio>
#include <cstdlib>

#include "reference/hard_cases/answers.h"
#include "reference/kernel/self_test.h"

int main(int argc, char** argv) {
    const std::uint64_t cases = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000;
    const std::string trouble = reference::kernel::arithmetic_trouble();
    if (!trouble.empty()) {
        std::printf("%s\n", trouble.c_str());
        return 1;
    }
    for (const auto& hard : reference::hard_cases::cases()) {
        const auto given = answer(hard, reference::hard_cases::Arithmetic::certified);
        if (given.decision == hard.decision && is_right(hard, given)) continue;
        std::printf("the hard case %s is answered wrongly\n", hard.id.data());
        return 1;
    }
    std::printf("%016llx\n", static_cast<unsigned long long>(reference::kernel::hash_of_decisions(cases)));
}
