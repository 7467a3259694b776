// Walks a ray through a tree, nearer boxes first. The walk tries the boxes of a node and the triangles of a leaf all at
// once; walk_body.h says how, walk_portable.cpp and walk_avx2.cpp with which instructions.
#pragma once

#include "reference/kernel/ray.h"
#include "reference/render/scene/tree.h"
#include "reference/render/scene/visitor.h"

namespace reference::render {

/// The ray may start anywhere within `uncertainty` of its origin, summed over the coordinates. Visits every object that
/// the ray may hit at a t from 0 to `until`, and perhaps other ones. Returns whether a visit ended the walk.
bool walk(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until, Visitor& visitor);

}  // namespace reference::render
