// Turns a measurement into pictures.
#pragma once

#include "harness/report/accuracy/summary.h"
#include "harness/report/plot/scatter.h"

namespace harness::report {

/// One distribution of one primitive: the rows that its pictures show, in the measurement's order.
struct Panel {
    reference::accuracy::Primitive primitive;
    std::string distribution;
    bool hard = false;
    std::vector<const reference::accuracy::Row*> rows;
};

/// One panel per primitive and distribution, in the measurement's order. The panels point into `measured`.
std::vector<Panel> panels_of(const reference::accuracy::Measurement& measured);

Scatter summary_scatter(const PrimitiveSummary& summary);
Scatter wrong_scatter(const Panel& panel, const std::string& id);
/// Shows only methods that give a t; has no points if none does.
Scatter error_scatter(const Panel& panel, const std::string& id);

}  // namespace harness::report
