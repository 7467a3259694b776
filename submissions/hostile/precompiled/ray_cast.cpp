// Tries: to have the compiler load another file as a precompiled header. Outcome: compile_error.
#pragma GCC pch_preprocess "/tmp/raygrade-decoy/answer_key.json"

#error the pragma counts in preprocessed text only
