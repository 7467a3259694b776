// The walk in the instructions that every processor has. It says what the walk with other ones computes.
#include "reference/render/scene/walk_body.h"

namespace reference::render {
namespace {

class PortableBoxes {
  public:
    explicit PortableBoxes(const TreeRay& ray) : ray_(ray) {}

    KERNEL_INLINE unsigned meets(const Node& node, float until, float* near) const {
        float far[children_per_node];
        for (std::size_t i = 0; i < children_per_node; ++i) {
            near[i] = 0;
            far[i] = until;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float* const enter = node.sides[ray_.enter[axis]].data();
            const float* const leave = node.sides[ray_.enter[axis] ^ 1U].data();
            const float inverse = ray_.inverse[axis];
            for (std::size_t i = 0; i < children_per_node; ++i) {
                const float from = enter[i] * inverse - ray_.near_shift[axis];
                const float to = leave[i] * inverse - ray_.far_shift[axis];
                near[i] = from > near[i] ? from : near[i];
                far[i] = to < far[i] ? to : far[i];
            }
        }
        unsigned met = 0;
        for (std::size_t i = 0; i < children_per_node; ++i) met |= static_cast<unsigned>(near[i] <= far[i]) << i;
        return met;
    }

  private:
    TreeRay ray_;
};

class PortableTriangles {
  public:
    PortableTriangles(const kernel::Ray<double>& ray, double uncertainty) : ray_(ray), uncertainty_(uncertainty) {}

    HitLanes hits(const Leaf& leaf, double until, Lanes& t) const {
        HitLanes found{0, 0};
        for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
            const kernel::PreparedTriangle<double> triangle(leaf.triangle(lane));
            kernel::TriangleFilter filter(ray_, triangle);
            allow_for_start(filter, ray_.direction, uncertainty_, triangle.edges);
            if (is_missed(filter)) continue;
            if (!filter.is_known_with_t()) {
                found.open |= 1U << lane;
                continue;
            }
            t[lane] = filter.t();
            if (t[lane] <= until) found.hits |= 1U << lane;
        }
        return found;
    }

  private:
    /// What is far from a hit is known to be missed, however little is known of the rest.
    static bool is_missed(const kernel::TriangleFilter& filter) {
        return filter.det > filter.error && (filter.inside < -filter.error || filter.t_numerator < -filter.t_error);
    }

    kernel::Ray<double> ray_;
    double uncertainty_;
};

struct Portable {
    using Boxes = PortableBoxes;
    using Triangles = PortableTriangles;
};

}  // namespace

bool walk_portable(const Tree& tree, const kernel::Ray<double>& ray, double uncertainty, double until,
                   Visitor& visitor) {
    return walk_with<Portable>(tree, ray, uncertainty, until, visitor);
}

}  // namespace reference::render
