// Tries: to include the answer key by a name put together by macros. Outcome: compile_error.
#define TEXT(name) #name
#define QUOTED(name) TEXT(name)
#define FOLDER /tmp/raygrade-decoy
#include QUOTED(FOLDER/answer_key.json)

int main() {}
