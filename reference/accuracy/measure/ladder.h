// measure() with the methods as a parameter.
#pragma once

#include "reference/accuracy/measure/measurement.h"
#include "reference/accuracy/methods/block_methods.h"

namespace reference::accuracy {

Ladder ladder();

Measurement measure(const MeasureOptions& options, const Ladder& ladder);

}  // namespace reference::accuracy
