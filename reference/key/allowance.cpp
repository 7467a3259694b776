#include "reference/key/allowance.h"

#include <algorithm>
#include <utility>

#include "reference/key/formulations.h"

namespace reference {
namespace {

using Range = Interval<double>;

bool is_bounded(const ItemBounds& ranges) {
    return std::all_of(ranges.begin(), ranges.end(), [](const Range& x) { return x.is_bounded(); });
}

/// Collects, item by item, the hull of the formulations: the whole line where one of them has no bound.
class Hulls {
  public:
    template <class Value>
    void add(const ItemId& id, const Value& formulation) {
        ItemBounds ranges;
        for (const auto& x : components(formulation)) ranges.push_back(x.range());
        ItemBounds& known = hulls_[id];
        if (known.empty()) known = ranges;
        for (std::size_t i = 0; i < ranges.size(); ++i) known[i] = hull(known[i], ranges[i]);
        if (!is_bounded(known)) known.assign(known.size(), Range::whole());
    }
    const std::map<ItemId, ItemBounds>& all() const { return hulls_; }

  private:
    std::map<ItemId, ItemBounds> hulls_;
};

/// x as a program reads it: rounded to float, or to anything finer.
Affine read_number(const Rational& x, Roundings& roundings) {
    const Enclosure doubles = enclose(x);
    return Affine::read(doubles.nearest, doubles.hi - doubles.lo, roundings);
}

/// The hull of the ways to compute a number, as a new number.
Affine any_of(const std::vector<Affine>& formulations, Roundings& roundings) {
    Range all = formulations.front().range();
    for (const Affine& formulation : formulations) all = hull(all, formulation.range());
    return {all, roundings};
}

AffineVec3 P_VCS_of(const Window<Affine>& window, const Pixel& pixel, PixelConvention convention,
                    Roundings& roundings) {
    const auto coordinate = [&](const Affine& from, const Affine& to, int index, int count) {
        const bool grid = convention == PixelConvention::grid;
        if (grid && count == 1) return any_of(window_coordinates(from, to, 0, 1, 1), roundings);
        const int halves = convention == PixelConvention::centre ? 1 : 0;
        return any_of(window_coordinates(from, to, index, grid ? count - 1 : count, halves), roundings);
    };
    return {coordinate(window.clip_left, window.clip_right, pixel.x, window.width),
            coordinate(window.clip_bottom, window.clip_top, pixel.y, window.height), -window.clip_near};
}

/// Collects the items of one basis after the other.
class Formulations {
  public:
    Formulations(const Scene<Affine>& scene, const Branches& branches, Roundings& roundings)
        : scene_(scene), branches_(branches), roundings_(roundings), of_scene_(roundings.random) {}

    void add(const AffineVec3& P_VCS, const Basis<Affine>& basis);
    void add_triangle_normal();
    const Hulls& hulls() const { return hulls_; }

  private:
    void add_matrix(const Mat4<Affine>& M);
    void add_ray(AffineVec3 start, AffineVec3 V);
    void add_sphere(const AffineVec3& start, const AffineVec3& V, const Sphere<Affine>& sphere);
    void add_hits(const AffineVec3& start, const AffineVec3& V, const Sphere<Affine>& sphere,
                  const std::vector<Affine>& ts);
    void add_cylinder(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder);
    void add_tube_hits(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder,
                       const std::vector<Affine>& ts);
    void add_cap_hits(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder, CylinderPart cap);
    void add_triangle(const AffineVec3& start, const AffineVec3& V, const Triangle<Affine>& triangle);

    const Scene<Affine>& scene_;
    const Branches& branches_;
    Roundings& roundings_;
    std::size_t of_scene_;  ///< how many random errors the scene's numbers have
    Hulls hulls_;
};

void Formulations::add(const AffineVec3& P_VCS, const Basis<Affine>& basis) {
    const AffineVec3& eye = scene_.camera.eye;
    hulls_.add(item::P_VCS, P_VCS);
    hulls_.add(item::X_vcs, basis.X_vcs);
    hulls_.add(item::Y_vcs, basis.Y_vcs);
    hulls_.add(item::Z_vcs, basis.Z_vcs);
    Alternatives ways(roundings_);
    for (int way = 0; way < inverse_views; ++way) {
        const Mat4<Affine> M = inverse_view(basis, eye, way);
        add_matrix(M);
        for (const AffineVec3& start : points_in_wcs(M, P_VCS)) {
            const std::vector<AffineVec3> all = directions(M, P_VCS, start, eye, roundings_);
            Alternatives rays(roundings_);
            for (const AffineVec3& V : all) {
                add_ray(start, V);
                rays.next();
            }
        }
        ways.next();
    }
}

void Formulations::add_triangle_normal() {
    if (scene_.triangles.empty()) return;
    for (const AffineVec3& normal : triangle_normals(scene_.triangles.at(branches_.triangle_index), roundings_))
        hulls_.add(item::triangle::normal, normal);
}

void Formulations::add_matrix(const Mat4<Affine>& M) {
    hulls_.add(item::M_VCS_to_WCS, M);
    // The axes as columns of an inverted view matrix.
    hulls_.add(item::X_vcs, AffineVec3(M[0]));
    hulls_.add(item::Y_vcs, AffineVec3(M[1]));
    hulls_.add(item::Z_vcs, AffineVec3(M[2]));
}

void Formulations::add_ray(AffineVec3 start, AffineVec3 V) {
    hulls_.add(item::P_WCS, start);
    hulls_.add(item::V, V);
    // What follows depends on the objects and on these six numbers alone.
    summarize(start, V);
    const std::size_t of_ray = std::exchange(roundings_.random, of_scene_);
    if (!scene_.spheres.empty()) add_sphere(start, V, scene_.spheres.at(branches_.sphere_index));
    roundings_.random = of_scene_;
    if (!scene_.triangles.empty()) add_triangle(start, V, scene_.triangles.at(branches_.triangle_index));
    roundings_.random = of_scene_;
    if (!scene_.cylinders.empty()) add_cylinder(start, V, scene_.cylinders.at(branches_.cylinder_index));
    roundings_.random = of_ray;
}

void Formulations::add_sphere(const AffineVec3& start, const AffineVec3& V, const Sphere<Affine>& sphere) {
    const bool hits = branches_.root == RootChoice::smaller || branches_.root == RootChoice::larger;
    const std::vector<Quadratic<Affine>> all = quadratics(start, V, sphere, roundings_);
    Alternatives ways(roundings_);
    for (const Quadratic<Affine>& quadratic : all) {
        hulls_.add(item::sphere::a, quadratic.a);
        hulls_.add(item::sphere::b, quadratic.b);
        hulls_.add(item::sphere::c, quadratic.c);
        hulls_.add(item::sphere::d, quadratic.d);
        if (hits) add_hits(start, V, sphere, sphere_roots(quadratic, branches_.root, roundings_));
        ways.next();
    }
    if (hits) add_hits(start, V, sphere, geometric_roots(start, V, sphere, branches_.root, roundings_));
}

void Formulations::add_hits(const AffineVec3& start, const AffineVec3& V, const Sphere<Affine>& sphere,
                            const std::vector<Affine>& ts) {
    Alternatives ways(roundings_);
    for (const Affine& t : ts) {
        const AffineVec3 hit = point_on_ray(start, V, t);
        const AffineVec3 outward = hit - sphere.center;
        hulls_.add(item::sphere::t, t);
        hulls_.add(item::sphere::hit, hit);
        hulls_.add(item::sphere::normal, unit_vector(outward));
        hulls_.add(item::sphere::normal, scaled(outward, Affine(Affine(1) / sphere.radius)));
        ways.next();
    }
}

void Formulations::add_triangle(const AffineVec3& start, const AffineVec3& V, const Triangle<Affine>& triangle) {
    const LinearSystem<Affine> system = triangle_system(start, V, triangle);
    hulls_.add(item::triangle::matrix, system.matrix);
    hulls_.add(item::triangle::rhs, system.rhs);
    if (!branches_.triangle_has_solution) return;
    const std::vector<AffineVec3> solutions = triangle_solutions(system, roundings_);
    Alternatives ways(roundings_);
    for (const AffineVec3& solution : solutions) {
        const auto& [t, u, v] = std::tie(solution.x, solution.y, solution.z);
        hulls_.add(item::triangle::t, t);
        hulls_.add(item::triangle::u, u);
        hulls_.add(item::triangle::v, v);
        hulls_.add(item::triangle::hit, point_on_ray(start, V, t));
        hulls_.add(item::triangle::hit, triangle.A + scaled(system.matrix[1], u) + scaled(system.matrix[2], v));
        hulls_.add(item::triangle::hit,
                   scaled(triangle.A, sum(Affine(1), -u, -v)) + scaled(triangle.B, u) + scaled(triangle.C, v));
        ways.next();
    }
}

void Formulations::add_cylinder(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder) {
    const CylinderPart part = branches_.cylinder_part;
    const RootChoice choice = tube_root(part);
    const bool hits_tube = choice == RootChoice::smaller || choice == RootChoice::larger;
    const std::vector<Quadratic<Affine>> all = tube_quadratics(start, V, cylinder, roundings_);
    Alternatives ways(roundings_);
    for (const Quadratic<Affine>& quadratic : all) {
        hulls_.add(item::cylinder::a, quadratic.a);
        hulls_.add(item::cylinder::b, quadratic.b);
        hulls_.add(item::cylinder::c, quadratic.c);
        hulls_.add(item::cylinder::d, quadratic.d);
        if (hits_tube) add_tube_hits(start, V, cylinder, quadratic_roots(quadratic, choice, roundings_));
        ways.next();
    }
    if (hits_tube) add_tube_hits(start, V, cylinder, geometric_tube_roots(start, V, cylinder, choice, roundings_));
    ways.next();
    const bool hits_cap = part == CylinderPart::top_cap || part == CylinderPart::bottom_cap;
    if (hits_cap) {
        add_cap_hits(start, V, cylinder, part);
        hulls_.add(item::cylinder::normal,
                   AffineVec3(Affine(), Affine(part == CylinderPart::top_cap ? 1 : -1), Affine()));
    }
    if (branches_.rim_cap) add_cap_hits(start, V, cylinder, *branches_.rim_cap);
}

void Formulations::add_tube_hits(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder,
                                 const std::vector<Affine>& ts) {
    Alternatives ways(roundings_);
    for (const Affine& t : ts) {
        const AffineVec3 hit = point_on_ray(start, V, t);
        hulls_.add(item::cylinder::t, t);
        hulls_.add(item::cylinder::hit, hit);
        for (const AffineVec3& normal : tube_normals(hit, cylinder, roundings_))
            hulls_.add(item::cylinder::normal, normal);
        ways.next();
    }
}

void Formulations::add_cap_hits(const AffineVec3& start, const AffineVec3& V, const Cylinder<Affine>& cylinder,
                                CylinderPart cap) {
    const CapHit met = cap_hit(start, V, cylinder, cap);
    hulls_.add(item::cylinder::t, met.t);
    for (const AffineVec3& hit : met.hits) hulls_.add(item::cylinder::hit, hit);
}

std::map<ItemId, ItemBounds> bounds_of(const Scene<Rational>& exact, PixelConvention convention,
                                       const Branches& branches) {
    Roundings roundings;
    const Scene<Affine> scene =
        convert_scene<Affine>(exact, [&](const Rational& x) { return read_number(x, roundings); });
    Formulations formulations(scene, branches, roundings);
    const AffineVec3 P_VCS = P_VCS_of(scene.window, scene.pixel, convention, roundings);
    formulations.add_triangle_normal();
    Alternatives ways(roundings);
    for (int way = 0; way < bases; ++way) {
        formulations.add(P_VCS, basis(scene.camera, way));
        ways.next();
    }
    return formulations.hulls().all();
}

}  // namespace

const std::map<ItemId, ItemBounds>& CorrectPrograms::bounds(PixelConvention convention, const Branches& branches) {
    const std::pair key(convention, branches);
    const auto found = known_.find(key);
    return found != known_.end() ? found->second
                                 : known_.emplace(key, bounds_of(scene_, convention, branches)).first->second;
}

}  // namespace reference
