#include "reference/accuracy/mesh/embree.h"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace reference::accuracy {

class EmbreeLibrary {
  public:
    using Object = void*;  ///< a device, a scene or a geometry

    Object (*new_device)(const char* config);
    void (*release_device)(Object device);
    Object (*new_scene)(Object device);
    void (*release_scene)(Object scene);
    void (*set_scene_flags)(Object scene, int flags);
    void (*commit_scene)(Object scene);
    Object (*new_geometry)(Object device, int type);
    void* (*set_new_geometry_buffer)(Object geometry, int type, unsigned slot, int format, std::size_t stride,
                                     std::size_t count);
    void (*commit_geometry)(Object geometry);
    unsigned (*attach_geometry)(Object scene, Object geometry);
    void (*release_geometry)(Object geometry);
    void (*intersect)(Object scene, embree_abi::Context* context, embree_abi::RayHit* hit);

    explicit EmbreeLibrary(void* library) : library_(library) {
        find("rtcNewDevice", new_device);
        find("rtcReleaseDevice", release_device);
        find("rtcNewScene", new_scene);
        find("rtcReleaseScene", release_scene);
        find("rtcSetSceneFlags", set_scene_flags);
        find("rtcCommitScene", commit_scene);
        find("rtcNewGeometry", new_geometry);
        find("rtcSetNewGeometryBuffer", set_new_geometry_buffer);
        find("rtcCommitGeometry", commit_geometry);
        find("rtcAttachGeometry", attach_geometry);
        find("rtcReleaseGeometry", release_geometry);
        find("rtcIntersect1", intersect);
    }
    ~EmbreeLibrary() { dlclose(library_); }
    EmbreeLibrary(const EmbreeLibrary&) = delete;
    EmbreeLibrary& operator=(const EmbreeLibrary&) = delete;

    bool is_whole() const { return is_whole_; }

  private:
    template <class Function>
    void find(const char* name, Function& function) {
        function = reinterpret_cast<Function>(dlsym(library_, name));
        is_whole_ = is_whole_ && function != nullptr;
    }

    void* library_;
    bool is_whole_ = true;
};

std::shared_ptr<const EmbreeLibrary> load_embree(const char* library) {
    void* const handle = dlopen(library, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);  // its threads may outlive us
    if (handle == nullptr) return nullptr;
    auto found = std::make_shared<const EmbreeLibrary>(handle);
    return found->is_whole() ? found : nullptr;
}

EmbreeScene::EmbreeScene(std::shared_ptr<const EmbreeLibrary> library, const Mesh& mesh, EmbreeMode mode)
    : library_(std::move(library)), device_(library_->new_device("threads=1")) {
    if (device_ == nullptr) throw std::runtime_error("Embree can't start on this machine");
    scene_ = library_->new_scene(device_);
    if (mode == EmbreeMode::robust) library_->set_scene_flags(scene_, embree_abi::robust);
    void* const geometry = library_->new_geometry(device_, embree_abi::triangles);
    const auto fill = [&](int type, int format, const auto& items) {
        using Item = typename std::decay_t<decltype(items)>::value_type;
        void* const buffer = library_->set_new_geometry_buffer(geometry, type, 0, format, sizeof(Item), items.size());
        std::copy(items.begin(), items.end(), static_cast<Item*>(buffer));
    };
    fill(embree_abi::vertex_buffer, embree_abi::three_floats, mesh.vertices);
    fill(embree_abi::index_buffer, embree_abi::three_indices, mesh.faces);
    library_->commit_geometry(geometry);
    library_->attach_geometry(scene_, geometry);
    library_->release_geometry(geometry);
    library_->commit_scene(scene_);
}

EmbreeScene::~EmbreeScene() {
    library_->release_scene(scene_);
    library_->release_device(device_);
}

void EmbreeScene::first_hits(std::span<const kernel::Ray<float>> rays, std::vector<MeshHit>& hits) const {
    embree_abi::Context context{0, nullptr, embree_abi::none, 0};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto& [origin, direction] = rays[i];
        embree_abi::RayHit hit{};
        std::copy_n(&origin.x, 3, hit.origin);
        std::copy_n(&direction.x, 3, hit.direction);
        hit.far = HUGE_VALF;
        hit.mask = ~0U;
        hit.geometry = embree_abi::none;
        library_->intersect(scene_, &context, &hit);
        hits[i] = {hit.geometry != embree_abi::none, hit.primitive, static_cast<double>(hit.far)};
    }
}

}  // namespace reference::accuracy
