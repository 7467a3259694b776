// Tries: to have the grade book quoted in the compiler's messages. Outcome: compile_error.
#include "/usr/../tmp/raygrade-decoy/gradebook.csv"

int main() {}
