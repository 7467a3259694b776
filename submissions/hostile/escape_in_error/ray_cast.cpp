// Tries: to rewrite the instructor's terminal by escape sequences in an error's text. Outcome: compile_error.
#error [2J[H]0;owned [32m100 of 100 points[0m Â›31m ÿþ
