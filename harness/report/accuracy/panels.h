// From a measurement to its pictures.
#pragma once

#include "harness/report/accuracy_summary.h"
#include "harness/report/scatter.h"

namespace harness::report {

/// One distribution of one primitive: the rows that its pictures show, in the measurement's order.
struct Panel {
    reference::accuracy::Primitive primitive;
    std::string distribution;
    bool hard = false;
    std::vector<const reference::accuracy::Row*> rows;
};

/// By primitive and distribution in the measurement's order; they point into it.
std::vector<Panel> panels_of(const reference::accuracy::Measurement& measured);

Scatter summary_scatter(const PrimitiveSummary& summary);
Scatter wrong_scatter(const Panel& panel, const std::string& id);
/// Of the methods that give a t; without points where none does.
Scatter error_scatter(const Panel& panel, const std::string& id);

}  // namespace harness::report
