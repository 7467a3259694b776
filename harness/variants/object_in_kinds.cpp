#include "harness/variants/object_in_kinds.h"

namespace harness::variants {
namespace {

/// Without an object that has its own name for the kind.
std::string_view to_string(Kind kind) {
    switch (kind) {
        case Kind::off_axis: return "camera off every axis";
        case Kind::in_front: return "another pixel";
        case Kind::beside: return "another camera";
        case Kind::grazing: return "far away";
    }
    return "";
}

}  // namespace

const ObjectInKinds& in_kinds(reference::Subject object) {
    const ObjectInKinds* found = nullptr;
    reference::for_each_object([&]<reference::Subject each>() {
        if (each == object) found = &in_kinds<each>();
    });
    return *found;
}

std::string_view name_of(Kind kind, const source::DecimalScene& scene) {
    for (const reference::Subject object : reference::objects) {
        if (reference::count_of(object, scene) == 0) continue;
        if (const std::string_view name = in_kinds(object).name_of(kind); !name.empty()) return name;
    }
    return to_string(kind);
}

}  // namespace harness::variants
