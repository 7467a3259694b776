// Tries: a sum of 500,000 terms. Outcome: compile_error.
#define T1 x + x + x + x + x + x + x + x + x + x +
#define T2 T1 T1 T1 T1 T1 T1 T1 T1 T1 T1
#define T3 T2 T2 T2 T2 T2 T2 T2 T2 T2 T2
#define T4 T3 T3 T3 T3 T3 T3 T3 T3 T3 T3
#define T5 T4 T4 T4 T4 T4 T4 T4 T4 T4 T4

double sum(double x) { return T5 T5 T5 T5 T5 x; }
int main() { return sum(1) > 0; }
