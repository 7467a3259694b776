// Rays at one scene by the million: as JSON lines, or as records for programs.
#pragma once

#include <iosfwd>

#include "reference/cast/first_hit.h"

namespace reference::cast {

/// Reads rays, one per line, with numbers as in queries.h:
///   {"origin":[x,y,z],"direction":[x,y,z]}
///
/// Writes one line per ray, in order:
///   {"first":"mesh 0","face":17,"t":1.5,"u":0.25,"v":0.25}
///   {"first":"triangle 2","tie":true,"t":1.5,"u":0,"v":0.25}
///   {"first":"sphere 1","t":0.5}
///   {"first":"cylinder 0","t":1,"part":"top"}
///   {"first":"none"}
///   {"first":"invalid"}
/// with the fields of FirstHit; "tie" appears only where it is true, and t is null if it exceeds the range of doubles.
///
/// A malformed line gives {"error":"...","line":7}, with lines counted from 1; the other lines are still answered.
/// Returns the number of malformed lines. Any number of threads gives the same answers; jobs >= 1. `scene` is from
/// objects_of.
long answer_lines(const render::PreparedScene& scene, std::istream& rays, std::ostream& answers, int jobs);

/// A ray: the origin's x, y and z, then the direction's, as little-endian doubles.
constexpr std::size_t ray_bytes = 48;
/// An answer, little-endian: kind, index and face as FirstHit has them, in 4 bytes each; a byte for the part (0 tube, 1
/// top, 2 bottom), one for is_tie (0 or 1), two zeros; t, u and v as doubles. What does not apply is 0, and t is
/// infinite if it exceeds the range of doubles.
constexpr std::size_t answer_bytes = 40;

struct RecordsRead {
    std::uint64_t whole;    ///< all are answered
    std::size_t left_over;  ///< bytes of a record that was cut off
};

/// The same for records.
RecordsRead answer_records(const render::PreparedScene& scene, std::istream& rays, std::ostream& answers, int jobs);

}  // namespace reference::cast
