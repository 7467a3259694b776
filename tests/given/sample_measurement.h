// Hand-made measurements: a crowded one as in practice, a small one, and a hostile one.
#pragma once

#include "reference/accuracy/measure/measurement.h"

namespace samples {

/// Some methods of each primitive, most of them within two nanoseconds of each other, on benign and hard distributions.
reference::accuracy::Measurement ladder();

/// Two methods on one distribution: the first is never wrong and gives t; the second is wrong on 12 of 1000 rays and
/// gives no t.
reference::accuracy::Measurement two_methods();

/// `two_methods` with markup, quotes, control bytes and line breaks in the names.
reference::accuracy::Measurement hostile();

}  // namespace samples
