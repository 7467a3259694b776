#include "reference/accuracy/measure/ladder.h"

namespace reference::accuracy {
namespace {

template <class Methods>
std::vector<std::string> names(const Methods& methods) {
    std::vector<std::string> result;
    for (const auto& method : methods) result.push_back(method.name());
    return result;
}

}  // namespace

Ladder ladder() {
    return {sphere_methods(), triangle_methods(), cast_methods(), sphere_block_methods(), triangle_block_methods()};
}

Measurement measure(const MeasureOptions& options) {
    return measure(options, ladder());
}

std::vector<std::string> method_names(Primitive primitive) {
    switch (primitive) {
        case Primitive::sphere: return names(sphere_methods());
        case Primitive::triangle: return names(triangle_methods());
        case Primitive::cast: return names(cast_methods());
        case Primitive::mesh: return {};
    }
    return {};
}

std::string name_of(Primitive primitive) {
    switch (primitive) {
        case Primitive::sphere: return "sphere";
        case Primitive::triangle: return "triangle";
        case Primitive::cast: return "cast";
        case Primitive::mesh: return "mesh";
    }
    return "";
}

}  // namespace reference::accuracy
