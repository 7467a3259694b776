#include "harness/variants/random/cylinder_meeting.h"

#include <cmath>

namespace harness::variants {

CylinderMeeting cylinder_meeting(const reference::CameraAnswers<double>& ray,
                                 const reference::Cylinder<double>& cylinder) {
    const reference::Vec3<double>& V = ray.V;
    const reference::Vec3<double> start = ray.P_WCS - cylinder.center;
    const double R2 = cylinder.radius * cylinder.radius;
    const double half = cylinder.height / 2;
    const double a = V.x * V.x + V.z * V.z;
    const double beside = (start.x * V.z - start.z * V.x) / std::sqrt(a);  // distance of the ray from the axis
    const double middle = -(start.x * V.x + start.z * V.z) / a;
    const double spread = std::sqrt((R2 - beside * beside) / a);
    CylinderMeeting meeting{};
    meeting.steepness = std::abs(V.y);
    meeting.share = 1 - beside * beside / R2;
    meeting.enters = middle - spread;
    meeting.leaves = middle + spread;
    meeting.height_at_enters = (start.y + meeting.enters * V.y) / half;
    meeting.height_at_leaves = (start.y + meeting.leaves * V.y) / half;
    meeting.cap_t = ((V.y < 0 ? half : -half) - start.y) / V.y;
    const double x = start.x + meeting.cap_t * V.x;
    const double z = start.z + meeting.cap_t * V.z;
    meeting.cap_share = 1 - (x * x + z * z) / R2;
    return meeting;
}

}  // namespace harness::variants
