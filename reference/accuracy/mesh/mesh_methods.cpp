#include "reference/accuracy/mesh/mesh_methods.h"

#include "reference/accuracy/mesh/mesh_judge.h"
#include "reference/accuracy/mesh/plain_tree.h"
#include "reference/render/scene/instructions.h"

namespace reference::accuracy {
namespace {

MeshMethod certified(render::PreparedScene& scene, render::Instructions instructions) {
    const bool is_portable = instructions == render::Instructions::portable;
    return {is_portable ? "certified" : "certified, AVX2", "double",
            "raygrade render: boxes and a filter with proven bounds, exact numbers where they leave it open", true,
            [&scene, instructions](const Rays<kernel::Ray>& rays, std::size_t count, std::vector<MeshHit>& hits) {
                scene.tree->instructions = instructions;
                for (std::size_t i = 0; i < count; ++i) hits[i] = certified_hit(scene, rays.doubles[i]);
            }};
}

template <class S>
MeshMethod textbook(const render::Tree& tree, const std::string& scalar,
                    std::vector<kernel::Ray<S>> Rays<kernel::Ray>::*rays) {
    return {"textbook", scalar, "the same tree: slabs without a margin, and Möller and Trumbore (1997)", false,
            [plain = std::make_shared<PlainTree<S>>(tree), rays](const Rays<kernel::Ray>& all, std::size_t count,
                                                                 std::vector<MeshHit>& hits) {
                for (std::size_t i = 0; i < count; ++i) hits[i] = plain->first_hit((all.*rays)[i]);
            }};
}

MeshMethod in_embree(const std::shared_ptr<const EmbreeLibrary>& embree, const Mesh& mesh, EmbreeMode mode) {
    return {mode == EmbreeMode::fast ? "Embree, fast" : "Embree, robust", "float",
            "Wald and others, \"Embree\" (2014), version 3, one ray at a time", false,
            [scene = std::make_shared<EmbreeScene>(embree, mesh, mode)](const Rays<kernel::Ray>& rays,
                                                                        std::size_t count, std::vector<MeshHit>& hits) {
                scene->first_hits(std::span(rays.floats).first(count), hits);
            }};
}

}  // namespace

std::vector<MeshMethod> mesh_methods(const Mesh& mesh, render::PreparedScene& scene,
                                     const std::shared_ptr<const EmbreeLibrary>& embree) {
    std::vector<MeshMethod> methods;
    for (const render::Instructions instructions : render::all_instructions()) {
        methods.push_back(certified(scene, instructions));
    }
    methods.push_back(textbook<double>(*scene.tree, "double", &Rays<kernel::Ray>::doubles));
    methods.push_back(textbook<float>(*scene.tree, "float", &Rays<kernel::Ray>::floats));
    if (embree != nullptr) {
        for (const EmbreeMode mode : {EmbreeMode::fast, EmbreeMode::robust}) {
            methods.push_back(in_embree(embree, mesh, mode));
        }
    }
    return methods;
}

}  // namespace reference::accuracy
