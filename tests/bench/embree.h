// An Embree scene of one geometry, for one ray at a time.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reference/kernel/ray.h"

class Embree {
  public:
    using Point = reference::Vec3<float>;
    using Face = std::array<unsigned, 3>;

    Embree(const std::vector<Point>& vertices, const std::vector<Face>& faces, RTCSceneFlags flags) : Embree(flags) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, vertices);
        fill(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, faces);
        commit(geometry);
    }
    Embree(const reference::Sphere<float>& sphere, RTCSceneFlags flags) : Embree(flags) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        const std::vector<std::array<float, 4>> spheres{
            {sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius}};
        fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, spheres);
        commit(geometry);
    }
    ~Embree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    std::size_t hits(const std::vector<reference::kernel::Ray<float>>& rays) const {
        std::size_t count = 0;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (const auto& [origin, direction] : rays) {
            RTCRayHit hit{};
            hit.ray = {origin.x, origin.y, origin.z, 0, direction.x, direction.y, direction.z, 0, HUGE_VALF, ~0U, 0, 0};
            hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene_, &context, &hit);
            count += hit.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
        return count;
    }

  private:
    explicit Embree(RTCSceneFlags flags) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, flags);
    }
    template <class X>
    static void fill(RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<X>& items) {
        auto* const buffer =
            static_cast<X*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(X), items.size()));
        std::copy(items.begin(), items.end(), buffer);
    }
    void commit(RTCGeometry geometry) {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }

    RTCDevice device_;
    RTCScene scene_;
};
