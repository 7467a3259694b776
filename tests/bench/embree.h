// An Embree scene of one geometry, for one ray at a time.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "reference/kernel/ray.h"

class Embree {
  public:
    using Point = reference::Vec3<float>;
    using Face = std::array<unsigned, 3>;

    Embree(const std::vector<Point>& vertices, const std::vector<Face>& faces, RTCSceneFlags flags, int threads = 1)
        : Embree(flags, threads) {
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

    std::size_t blocked(const std::vector<reference::kernel::Ray<float>>& rays) const {
        std::size_t count = 0;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        for (const auto& [origin, direction] : rays) {
            RTCRay ray{origin.x, origin.y, origin.z, 0, direction.x, direction.y, direction.z, 0, HUGE_VALF, ~0U, 0, 0};
            rtcOccluded1(scene_, &context, &ray);
            count += ray.tfar < 0 ? 1 : 0;
        }
        return count;
    }

    /// What its scenes hold at the moment.
    std::size_t bytes() const { return bytes_; }

  private:
    explicit Embree(RTCSceneFlags flags, int threads = 1)
        : device_(rtcNewDevice(("threads=" + std::to_string(threads)).c_str())), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, flags);
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void* bytes, ssize_t added, bool /*after*/) {
                *static_cast<std::size_t*>(bytes) += static_cast<std::size_t>(added);
                return true;
            },
            &bytes_);
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

    std::size_t bytes_ = 0;
    RTCDevice device_;
    RTCScene scene_;
};
