# That differences of computed t's decide which of two hits is first, proven by Gappa. ratio is the larger computed t
# divided by the smaller, and e1 and e2 are their relative errors. Where it is above 1 by the slack, so is the true one.
# Lines that begin with "#:" quote first.h, first.cpp, cylinder.h and visibility.cpp.
#:    const double slack = 0x1p-24 * std::min(at_sphere.t, at_triangle.t) + 0x1p-1000;
#:std::abs(leave - enter) > 0x1p-24 * least
#:    if (std::abs(difference) > 0x1p-24 * hit.t) return difference < 0;
to_float = ratio * (1 + e2) / (1 + e1);
# After order_of in first.cpp, where each t is within one unit in its last place.
#:    const double slack = 0x1p-50 * std::max(a.t, b.t) + 0x1p-1000;
to_double = close_ratio * (1 + d2) / (1 + d1);
# Before the light, which is at t = 1.
#:    if (hit.t < end * (1 - 0x1p-24)) return true;
#:    if (hit.t > end * (1 + 0x1p-24)) return false;
before = (1 - 1b-24) / (1 + e1);
behind = (1 + 1b-24) / (1 + e1);
# The slack and the difference are rounded once each.
{ ratio >= 0x1.000000fffp0 /\ ratio <= 2 /\ e1 in [-1b-26, 1b-26] /\ e2 in [-1b-26, 1b-26] /\
  close_ratio >= 0x1.0000000000003p0 /\ close_ratio <= 2 /\ d1 in [-1b-52, 1b-52] /\ d2 in [-1b-52, 1b-52]
-> 1 - before >= 1b-25 /\ behind - 1 >= 1b-25 /\ to_float - 1 >= 1b-30 /\ to_double - 1 >= 1b-54 }
