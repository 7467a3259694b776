// measure() with the methods as values: the whole ladder, or another one.
#pragma once

#include "reference/accuracy/measurement.h"
#include "reference/accuracy/method.h"

namespace reference::accuracy {

Ladder ladder();

Measurement measure(const MeasureOptions& options, const Ladder& ladder);

}  // namespace reference::accuracy
