// Walks a ray through a tree, nearer boxes first. The walk tries the boxes of a node and the triangles of a leaf all at
// once; walk_body.h says how, walk_portable.cpp and walk_avx2.cpp with which instructions.
#pragma once

#include "reference/kernel/triangle.h"
#include "reference/render/scene/tree.h"

namespace reference::render {

/// Objects of a leaf that the ray may hit, as bits by lane.
struct Found {
    const Leaf& leaf;
    unsigned hits;   ///< triangles that the filter knows to be hit, at `t`
    unsigned open;   ///< objects of which it knows nothing
    const Lanes& t;  ///< of hits, to a relative error of 2^-27
};

class Visitor {
  public:
    /// Shortens `until`, beyond which the caller wants no hits. Returns whether the walk is over.
    virtual bool visit(const Found& found, double& until) = 0;

  protected:
    ~Visitor() = default;
};

/// The ray may start anywhere within `uncertainty` of its origin, summed over the coordinates. Visits every object that
/// the ray may hit at a t from 0 to `until`, and perhaps other ones. Returns whether a visit ended the walk.
bool walk(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until, Visitor& visitor);

/// The fastest instructions of this machine.
Instructions best_instructions();
/// Those that it has, the portable ones first.
std::vector<Instructions> all_instructions();

/// A start that is off by x changes u, v and w times det by at most x |V|₁e, and t times det by at most x e².
KERNEL_INLINE void allow_for_start(kernel::TriangleFilter& filter, const Vec3<double>& direction, double uncertainty,
                                   double edges) {
    const double by = uncertainty * edges * (1 + 0x1p-40);
    filter.error += by * kernel::PreparedTriangle<double>::norm(direction);
    filter.t_error += by * edges;
}

}  // namespace reference::render
