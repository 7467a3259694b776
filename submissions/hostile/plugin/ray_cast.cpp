// Tries: to load a plugin into the compiler by a pragma. Outcome: graded.
#pragma GCC optimize("-fplugin=/tmp/raygrade-decoy/plugin.so")
#pragma GCC optimize("-fdump-tree-all=/tmp/raygrade-decoy/other/dump", "-o/tmp/raygrade-decoy/other/out")
#include <cstdio>

int main() { std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)"); }
