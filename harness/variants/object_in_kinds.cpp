#include "harness/variants/object_in_kinds.h"

namespace harness::variants {
const ObjectInKinds& in_kinds(reference::Subject object) {
    const ObjectInKinds* found = nullptr;
    reference::for_each_object([&]<reference::Subject subject>() {
        if (subject == object) found = &in_kinds<subject>();
    });
    return *found;
}

std::string_view name_of(Kind kind, const source::DecimalScene& scene) {
    constexpr std::array<std::string_view, all_kinds.size()> without_objects{"camera off every axis", "another pixel",
                                                                             "another camera", "far away"};
    const auto index = static_cast<std::size_t>(kind);
    for (const reference::Subject object : reference::objects) {
        const std::string_view name = in_kinds(object).names.at(index);
        if (reference::count_of(object, scene) > 0 && !name.empty()) return name;
    }
    return without_objects.at(index);
}

}  // namespace harness::variants
