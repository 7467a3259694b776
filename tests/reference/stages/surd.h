// Numbers m ± √q with rational m and q, and their order: exact where two are equal, by MPFR where they differ.
#pragma once

#include <gmpxx.h>

namespace truth {

/// m + sign √q; sign is 1 or -1, q at least 0.
struct Surd {
    mpq_class m;
    int sign = 1;
    mpq_class q = 0;
};

/// p + factor x.
Surd scaled_and_moved(const Surd& x, const mpq_class& factor, const mpq_class& p);

/// -1, 0 or 1 as x is smaller, equal or larger.
int compare(const Surd& x, const Surd& y);

}  // namespace truth
