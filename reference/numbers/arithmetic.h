// Rejects compiler flags that change the results of + - * /: every proof in this project needs IEEE 754 (2019),
// rounding to nearest. reference/kernel/self_test checks the rest, which no macro shows, when a program starts.
#pragma once

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0)
#error "Decisions are exact only without -ffast-math and the flags it consists of: compile the reference without them."
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "Decisions are exact only where doubles are computed as doubles: compile the reference without -mfpmath=387."
#endif
