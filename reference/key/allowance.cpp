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

/// x as a program reads it: rounded to float, or to a finer type.
Affine read_number(const Rational& x, Roundings& roundings) {
    const Enclosure doubles = enclose(x);
    return Affine::read(doubles.nearest, doubles.hi - doubles.lo, roundings);
}

/// The hull of several ways to compute a number, as a new number.
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

/// Collects the items of one basis after another.
class Formulations {
  public:
    Formulations(const Scene<Affine>& scene, const Branches& branches, Roundings& roundings)
        : scene_(scene), branches_(branches), roundings_(roundings), of_scene_(roundings.random) {}

    void add(const AffineVec3& P_VCS, const Basis<Affine>& basis);
    void add_objects();
    const Hulls& hulls() const { return hulls_; }

  private:
    void add_matrix(const Mat4<Affine>& M);
    void add_ray(AffineVec3 start, AffineVec3 V);

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

void Formulations::add_objects() {
    for_each_object_asked(
        [&](Subject /*kind*/, const auto& of_scene, const auto& branch) {
            if (!of_scene.empty()) add_without_ray(of_scene.at(branch.index), roundings_, hulls_);
        },
        scene_, branches_);
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
    // The later items depend only on the objects and on these six numbers.
    summarize(start, V);
    const std::size_t of_ray = std::exchange(roundings_.random, of_scene_);
    for_each_object_asked(
        [&](Subject /*kind*/, const auto& of_scene, const auto& branch) {
            roundings_.random = of_scene_;
            if (!of_scene.empty()) add_for_ray({start, V}, of_scene.at(branch.index), branch, roundings_, hulls_);
        },
        scene_, branches_);
    roundings_.random = of_ray;
}

std::map<ItemId, ItemBounds> bounds_of(const Scene<Rational>& exact, PixelConvention convention,
                                       const Branches& branches) {
    Roundings roundings;
    const Scene<Affine> scene =
        convert_scene<Affine>(exact, [&](const Rational& x) { return read_number(x, roundings); });
    Formulations formulations(scene, branches, roundings);
    const AffineVec3 P_VCS = P_VCS_of(scene.window, scene.pixel, convention, roundings);
    formulations.add_objects();
    Alternatives ways(roundings);
    for (int way = 0; way < bases; ++way) {
        formulations.add(P_VCS, basis(scene.camera, way));
        ways.next();
    }
    return formulations.hulls().all();
}

}  // namespace

void Hulls::add_ranges(const ItemId& id, const ItemBounds& ranges) {
    ItemBounds& known = hulls_[id];
    if (known.empty()) known = ranges;
    for (std::size_t i = 0; i < ranges.size(); ++i) known[i] = hull(known[i], ranges[i]);
    if (!is_bounded(known)) known.assign(known.size(), Range::whole());
}

const std::map<ItemId, ItemBounds>& CorrectPrograms::bounds(PixelConvention convention, const Branches& branches) {
    const std::pair key(convention, branches);
    const auto found = known_.find(key);
    return found != known_.end() ? found->second
                                 : known_.emplace(key, bounds_of(scene_, convention, branches)).first->second;
}

}  // namespace reference
