// Queries with their own objects: one JSON line in, one JSON line out.
#pragma once

#include <iosfwd>

namespace reference::cast {

/// Reads queries, one per line:
///   {"origin":[x,y,z],"direction":[x,y,z],"spheres":[{"center":[x,y,z],"radius":r}],"triangles":[[[x,y,z],[x,y,z],[x,y,z]]],
///    "cylinders":[{"center":[x,y,z],"radius":r,"height":h}]}
/// A cylinder's axis is parallel to y, and half its height is above the center.
/// Keys may come in any order; spheres, triangles and cylinders may be left out. A number is a JSON number, which
/// becomes the nearest double, or a string with a hex float ("0x1.8p+1"), "inf", "-inf" or "nan".
///
/// Writes one line per query, in order:
///   {"spheres":[{"result":"hit","t":0.5}],"triangles":[{"result":"hit","t":3,"u":0.25,"v":0.25}],"first":"sphere 0"}
/// with the results of kernel/ray.h: hit, miss, tangent, coplanar, degenerate, invalid; t, u and v appear only with hit
/// and tangent, and t is null if it exceeds the range of doubles. `first` is "sphere 0", "triangle 0", "cylinder 0"
/// (counted from 0), "tie", "none" or "invalid". If the query has a cylinder, the answer has
///   "cylinders":[{"result":"hit","t":1,"part":"tube"}]
/// after the triangles; the part is tube, top or bottom, and appears with t.
///
/// A malformed line gives {"error":"...","line":7}, with lines counted from 1; the other lines are still answered.
/// Returns the number of malformed lines. Ends early if `answers` can't be written to.
long answer_queries(std::istream& queries, std::ostream& answers);

}  // namespace reference::cast
