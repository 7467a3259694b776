// Tries: Fibonacci in a constant expression, made so that nothing can be remembered. Outcome: compile_error.
constexpr long fibonacci(int n, long path) {
    return n < 2 ? n + path % 2 : fibonacci(n - 1, 2 * path) + fibonacci(n - 2, 2 * path + 1);
}

constexpr long value = fibonacci(45, 1);
static_assert(value > 0);
int main() {}
