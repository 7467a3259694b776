// Embree (Wald and others, 2014), if its library is on this machine. It is loaded while the program runs, so that the
// program neither needs it nor is built with its headers; what its interface of version 3 fixes is declared here, and
// tests/bench/mesh_bench.cpp compares it with Embree's own headers.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "reference/accuracy/mesh/mesh.h"
#include "reference/accuracy/mesh/mesh_hit.h"

namespace reference::accuracy {

namespace embree_abi {

/// RTCRayHit
struct alignas(16) RayHit {
    float origin[3];
    float near;
    float direction[3];
    float time;
    float far;
    unsigned mask;
    unsigned id;
    unsigned flags;
    float normal[3];
    float u;
    float v;
    unsigned primitive;
    unsigned geometry;
    unsigned instance;
};

/// RTCIntersectContext. Some builds of Embree read one more number, which is 0 by default.
struct Context {
    int flags;
    void* filter;
    unsigned instance;
    float more;
};

constexpr unsigned none = ~0U;
constexpr int triangles = 0;           ///< RTC_GEOMETRY_TYPE_TRIANGLE
constexpr int index_buffer = 0;        ///< RTC_BUFFER_TYPE_INDEX
constexpr int vertex_buffer = 1;       ///< RTC_BUFFER_TYPE_VERTEX
constexpr int three_floats = 0x9003;   ///< RTC_FORMAT_FLOAT3
constexpr int three_indices = 0x5003;  ///< RTC_FORMAT_UINT3
constexpr int robust = 4;              ///< RTC_SCENE_FLAG_ROBUST

}  // namespace embree_abi

class EmbreeLibrary;

/// Null if there is no such library.
std::shared_ptr<const EmbreeLibrary> load_embree(const char* library = "libembree3.so.3");

/// How to get it, for people.
constexpr const char* embree_is_missing = "Embree isn't installed: its two rows are missing; apt install libembree3-3";

enum class EmbreeMode { fast, robust };

/// A mesh in Embree, for one ray at a time.
class EmbreeScene {
  public:
    EmbreeScene(std::shared_ptr<const EmbreeLibrary> library, const Mesh& mesh, EmbreeMode mode);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// hits[i] for rays[i].
    void first_hits(std::span<const kernel::Ray<float>> rays, std::vector<MeshHit>& hits) const;

  private:
    std::shared_ptr<const EmbreeLibrary> library_;
    void* device_;
    void* scene_;
};

}  // namespace reference::accuracy
