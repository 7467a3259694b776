// The plots of a primitive. A method has the same number in both.
#pragma once

#include "harness/report/accuracy/scatter.h"
#include "harness/report/accuracy/summary.h"

namespace harness::report {

/// Time on benign rays against wrong decisions on hard ones.
Scatter wrong_scatter(const PrimitiveSummary& summary);

/// Time against the error of t, both on benign rays. Shows only methods that give a t; has no points if none does.
Scatter error_scatter(const PrimitiveSummary& summary);

}  // namespace harness::report
