// A bundle supplies the <algorithm> that is missing: this does not compile.
#include <cstdio>
#include <vector>
int main() {
    std::vector<int> v{3, 1, 2};
    std::sort(v.begin(), v.end());
    std::printf("%d\n", v[0]);
}
