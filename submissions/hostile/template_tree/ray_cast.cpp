// Tries: 2^26 instances of a template. Outcome: compile_error.
template <int depth, int path>
struct Tree {
    static constexpr int value = Tree<depth - 1, 2 * path>::value ^ Tree<depth - 1, 2 * path + 1>::value;
};
template <int path>
struct Tree<0, path> {
    static constexpr int value = path;
};

int main() { return Tree<26, 1>::value % 100; }
