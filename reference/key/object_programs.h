// The results of correct programs for each kind of object: every item's range over the ways to compute it, and why
// float is inaccurate there. Each kind's file defines its functions.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "reference/key/formulations.h"
#include "reference/numbers/certified.h"
#include "reference/stages/scene_answers.h"

namespace reference {

/// The range of correct programs' numbers for an item, by component; the whole line for each if a formulation has no
/// bound for one, because a divisor may be zero, or a number may overflow.
using ItemBounds = std::vector<Interval<double>>;

/// Collects, item by item, the hull of the formulations: the whole line if one of them has no bound.
class Hulls {
  public:
    template <class Value>
    void add(const ItemId& id, const Value& formulation) {
        ItemBounds ranges;
        for (const auto& x : components(formulation)) ranges.push_back(x.range());
        add_ranges(id, ranges);
    }
    const std::map<ItemId, ItemBounds>& all() const { return hulls_; }

  private:
    void add_ranges(const ItemId& id, const ItemBounds& ranges);
    std::map<ItemId, ItemBounds> hulls_;
};

struct AffineRay {
    AffineVec3 start;
    AffineVec3 V;
};

// The choices of the exact decisions for the item's object, which is the one with this index.
struct SphereBranch {
    RootChoice root = RootChoice::miss;
    std::size_t index = 0;
    friend auto operator<=>(const SphereBranch&, const SphereBranch&) = default;
};
struct TriangleBranch {
    bool has_solution = false;  ///< det is not 0
    std::size_t index = 0;
    friend auto operator<=>(const TriangleBranch&, const TriangleBranch&) = default;
};
struct CylinderBranch {
    CylinderPart part = CylinderPart::miss;
    std::optional<CylinderPart> rim_cap = {};  ///< the cap whose rim the ray hits
    std::size_t index = 0;
    friend auto operator<=>(const CylinderBranch&, const CylinderBranch&) = default;
};
SphereBranch branch_of(const SphereAnswers<Certified>& sphere);
TriangleBranch branch_of(const TriangleAnswers<Certified>& triangle);
CylinderBranch branch_of(const CylinderAnswers<Certified>& cylinder);

/// Adds the items that depend on the object alone.
void add_without_ray(const Sphere<Affine>& sphere, Roundings& roundings, Hulls& hulls);
void add_without_ray(const Triangle<Affine>& triangle, Roundings& roundings, Hulls& hulls);
void add_without_ray(const Cylinder<Affine>& cylinder, Roundings& roundings, Hulls& hulls);

/// Adds the items that depend on the ray.
void add_for_ray(const AffineRay& ray, const Sphere<Affine>& sphere, const SphereBranch& branch, Roundings& roundings,
                 Hulls& hulls);
void add_for_ray(const AffineRay& ray, const Triangle<Affine>& triangle, const TriangleBranch& branch,
                 Roundings& roundings, Hulls& hulls);
void add_for_ray(const AffineRay& ray, const Cylinder<Affine>& cylinder, const CylinderBranch& branch,
                 Roundings& roundings, Hulls& hulls);

/// A reason why float is inaccurate, and how to fix it.
struct Reason {
    double factor;  ///< by which it amplifies errors
    std::string_view what;
    std::string_view way_out;
};

/// How much narrower than a right angle the angle of p and q is: 1 over its sine.
inline double narrowness(const Vec3<double>& p, const Vec3<double>& q) {
    return length(p) * length(q) / length(cross(p, q));
}

/// The causes that amplify errors in the object's items.
std::vector<Reason> reasons_of(const Sphere<double>& sphere, const SphereAnswers<double>& answers,
                               const CameraAnswers<double>& camera);
std::vector<Reason> reasons_of(const Triangle<double>& triangle, const TriangleAnswers<double>& answers,
                               const CameraAnswers<double>& camera);
std::vector<Reason> reasons_of(const Cylinder<double>& cylinder, const CylinderAnswers<double>& answers,
                               const CameraAnswers<double>& camera);

}  // namespace reference
