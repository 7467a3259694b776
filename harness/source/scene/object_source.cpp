#include "harness/source/scene/object_source.h"

#include <algorithm>

namespace harness::source {

using reference::Subject;

void FoundParts::take(const StatedNumber& number, ScenePart part, std::size_t component, bool splat, double offset) {
    if (!number.certain) doubtful.insert(part);
    literals.push_back({number.begin, number.end, part, component, splat, offset, number.constant, number.in_define});
}

bool FoundParts::states(ScenePart part) const {
    return !doubtful.contains(part) &&
           std::ranges::any_of(literals, [&](const SceneLiteral& literal) { return literal.part == part; });
}

const ObjectSource& source_of(Subject object) {
    const ObjectSource* source = nullptr;
    reference::for_each_object([&]<Subject subject>() {
        if (subject == object) source = &source_of<subject>();
    });
    return *source;
}

}  // namespace harness::source
