#include "reference/accuracy/mesh/mesh_rays.h"

#include <algorithm>
#include <cmath>

namespace reference::accuracy {
namespace {

/// The cube around the mesh.
struct Room {
    P middle;
    double reach = 0;  ///< half a side
};

Room room_of(const Mesh& mesh) {
    P low(mesh.vertices.front());
    P high = low;
    for (const Vec3<float>& vertex : mesh.vertices) {
        low = glm::min(low, P(vertex));
        high = glm::max(high, P(vertex));
    }
    const P half = scaled(high - low, 0.5);
    return {low + half, std::max({half.x, half.y, half.z})};
}

/// Which faces meet at an edge and at a vertex.
class Meetings {
  public:
    explicit Meetings(const Mesh& mesh) : mesh_(mesh), edges_(edges_of(mesh)) {}

    const EdgeOfFace& any_edge(Random& random) const { return edges_[random.bits() % edges_.size()]; }

    bool is_seen_from_one_side(const EdgeOfFace& edge, const P& from) const {
        const int side = side_of(edge.face, from);
        return all_on(side, edge.from, edge.to, from) && all_on(side, edge.to, edge.from, from);
    }
    bool is_seen_from_one_side(std::uint32_t vertex, const P& from) const {
        const auto first = std::lower_bound(edges_.begin(), edges_.end(), EdgeOfFace{vertex, 0, 0});
        return all_on(side_of(first->face, from), vertex, first, from);
    }

  private:
    using Place = std::vector<EdgeOfFace>::const_iterator;

    int side_of(std::uint32_t face, const P& from) const {
        const auto [A, B, C] = mesh_.triangle<double>(face);
        const double side = dot(cross(P(B - A), P(C - A)), P(from - A));
        return side > 0 ? 1 : (side < 0 ? -1 : 0);
    }
    bool is_on(int side, std::uint32_t face, const P& from) const { return side != 0 && side_of(face, from) == side; }
    bool all_on(int side, std::uint32_t a, std::uint32_t b, const P& from) const {
        auto edge = std::lower_bound(edges_.begin(), edges_.end(), EdgeOfFace{a, b, 0});
        for (; edge != edges_.end() && edge->from == a && edge->to == b; ++edge) {
            if (!is_on(side, edge->face, from)) return false;
        }
        return true;
    }
    /// Each face at the vertex leaves it through one edge.
    bool all_on(int side, std::uint32_t vertex, Place edge, const P& from) const {
        for (; edge != edges_.end() && edge->from == vertex; ++edge) {
            if (!is_on(side, edge->face, from)) return false;
        }
        return true;
    }

    const Mesh& mesh_;
    std::vector<EdgeOfFace> edges_;
};

constexpr double around = 1.5;  ///< rays start within so many times the mesh's reach

Vec3<float> start_near(const Room& room, Random& random) {
    return Vec3<float>(room.middle + random.point(around * room.reach));
}

void add_ray(MeshRays& set, const Vec3<float>& origin, const P& direction) {
    const kernel::Ray<float> ray{origin, Vec3<float>(direction)};
    set.rays.floats.push_back(ray);
    set.rays.doubles.push_back(kernel::as_double(ray));
}

MeshRays of_a_camera(const Room& room, std::uint64_t count) {
    MeshRays set{"camera", false, {}};
    const auto side = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const Vec3<float> eye(room.middle + scaled(P(0, 1, 3), room.reach));
    const auto place = [&](std::uint64_t i) {
        return (2 * static_cast<double>(i) + 1) / static_cast<double>(side) - 1;
    };
    for (std::uint64_t i = 0; i < count; ++i) {
        add_ray(set, eye, room.middle + scaled(P(place(i % side), place(i / side), 0), 1.2 * room.reach) - P(eye));
    }
    return set;
}

MeshRays scattered(const Room& room, std::uint64_t count, Random& random) {
    MeshRays set{"scattered", false, {}};
    for (std::uint64_t i = 0; i < count; ++i) add_ray(set, start_near(room, random), random.direction());
    return set;
}

/// A start from which the way to x is a float: any in x's half to double, by Sterbenz's lemma, and any for 0.
float exact_start(float x, double low, double high, Random& random) {
    if (x == 0) return static_cast<float>(random.between(low, high));
    const double least = std::max(low, std::min(x / 2.0, 2.0 * x));
    const double most = std::min(high, std::max(x / 2.0, 2.0 * x));
    return static_cast<float>(least < most ? random.between(least, most) : static_cast<double>(x));
}
Vec3<float> exact_start(const Vec3<float>& p, const Room& room, Random& random) {
    const auto start = [&](int axis) {
        const double reach = around * room.reach;
        return exact_start(p[axis], room.middle[axis] - reach, room.middle[axis] + reach, random);
    };
    const float x = start(0);
    const float y = start(1);
    return {x, y, start(2)};
}

enum class Aim {
    near,     ///< a place is passed as near as the rounding of the direction lets it
    through,  ///< a place is met exactly
};

/// Draws places, as pairs of a point and of what meets there, and starts, until the start sees what meets there from
/// one side and the ray meets the place as it is to.
template <class Draw>
MeshRays aimed(const std::string& name, Aim aim, const Room& room, const Meetings& meetings, std::uint64_t count,
               Random& random, Draw draw) {
    constexpr int most_tries = 100;
    MeshRays set{name, true, {}};
    for (std::uint64_t i = 0; i < count; ++i) {
        for (int tries = 1;; ++tries) {
            const auto [point, place] = draw(random);
            const Vec3<float> origin =
                aim == Aim::near ? start_near(room, random) : exact_start(Vec3<float>(point), room, random);
            const P way = point - P(origin);
            const bool meets = aim == Aim::near || P(Vec3<float>(way)) == way;
            const bool is_wanted = meets && meetings.is_seen_from_one_side(place, P(origin));
            if (!is_wanted && tries < most_tries) continue;
            add_ray(set, origin, way);
            break;
        }
    }
    return set;
}

}  // namespace

std::vector<MeshRays> rays_at(const Mesh& mesh, std::uint64_t seed, std::uint64_t count) {
    const Room room = room_of(mesh);
    const Meetings meetings(mesh);
    Random random(seed);
    const auto on_edge = [&](auto share) {
        return [&, share](Random& numbers) {
            const EdgeOfFace& edge = meetings.any_edge(numbers);
            const P from(mesh.vertices[edge.from]);
            return std::pair(P(from + scaled(P(mesh.vertices[edge.to]) - from, share(numbers))), edge);
        };
    };
    const auto anywhere = on_edge([](Random& numbers) { return numbers.between(0, 1); });
    const auto middle = on_edge([](Random& /*numbers*/) { return 0.5; });
    const auto vertex = [&](Random& numbers) {
        const std::uint32_t place = meetings.any_edge(numbers).from;
        return std::pair(P(mesh.vertices[place]), place);
    };
    std::vector<MeshRays> all;
    all.push_back(of_a_camera(room, count));
    all.push_back(scattered(room, count, random));
    all.push_back(aimed("at edges", Aim::near, room, meetings, count, random, anywhere));
    all.push_back(aimed("at vertices", Aim::near, room, meetings, count, random, vertex));
    all.push_back(aimed("through edges", Aim::through, room, meetings, count, random, middle));
    all.push_back(aimed("through vertices", Aim::through, room, meetings, count, random, vertex));
    return all;
}

}  // namespace reference::accuracy
