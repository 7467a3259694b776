// Turns a measurement into plots. A method has the same number in all plots of its primitive.
#pragma once

#include "harness/report/accuracy/scatter.h"
#include "harness/report/accuracy/summary.h"

namespace harness::report {

Scatter summary_scatter(const PrimitiveSummary& summary);
Scatter wrong_scatter(const Panel& panel, const std::string& id);
/// Shows only methods that give a t; has no points if none does.
Scatter error_scatter(const Panel& panel, const std::string& id);

}  // namespace harness::report
