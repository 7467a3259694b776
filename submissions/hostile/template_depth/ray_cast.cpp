// Tries: a template that needs itself without end. Outcome: compile_error.
template <int n>
struct Endless {
    static constexpr int value = Endless<n + 1>::value;
};

int main() { return Endless<0>::value; }
