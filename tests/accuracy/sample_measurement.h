// Hand-made measurements: as crowded as a real one, and as hostile as none should be.
#pragma once

#include "reference/accuracy/measurement.h"

namespace samples {

/// Every method of the ladder, most of them within two nanoseconds of each other, on benign and hard distributions.
reference::accuracy::Measurement ladder();

/// Two methods on one distribution: the first never wrong and with a t, the second wrong on 12 of 1000 rays, without.
reference::accuracy::Measurement two_methods();

/// `two_methods` with markup, quotes, control bytes and formulas for names.
reference::accuracy::Measurement hostile();

}  // namespace samples
