// What a walk through a tree calls for the objects that a ray may hit.
#pragma once

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

}  // namespace reference::render
