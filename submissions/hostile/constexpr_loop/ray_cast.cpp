// Tries: loops in a constant expression, each within what the compiler allows a loop. Outcome: compile_error.
constexpr long spin() {
    long sum = 0;
    for (int i = 0; i < 200000; ++i) {
        for (int j = 0; j < 200000; ++j) sum += j;
    }
    return sum;
}

constexpr long value = spin();
static_assert(value > 0);
int main() {}
