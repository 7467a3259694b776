// What other scenes must do with a new kind of object: reference/adding-an-object.md.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "harness/source/scene/part_name.h"
#include "harness/variants/generate.h"
#include "reference/numbers/decimal.h"

namespace harness::variants {
namespace {

using reference::Subject;

/// The handout's camera and one object.
reference::Assignment with_only(Subject object) {
    reference::Assignment assignment = reference::load_assignment("a6-2024", RAYGRADE_ASSIGNMENTS);
    reference::for_each_kind(
        [&](Subject kind, auto& objects) {
            if (kind != object || objects.empty()) objects.resize(kind == object ? 1 : 0);
        },
        assignment.scene);
    for (const source::ScenePart part : source::parts_of(object)) {
        if (source::value_of(assignment.scene, part) != std::array<double, 3>{}) continue;
        const auto decimal = [](const char* text) { return reference::Decimal::parse(text).value(); };
        source::set_part(assignment.scene, part, {decimal("1"), decimal("2"), decimal("0.5")});
    }
    return assignment;
}

TEST(VariantsOfEveryObject, MoveEachOfItsParts) {
    for (const Subject object : reference::objects) {
        const reference::Assignment assignment = with_only(object);
        const source::PartSet located(source::all_parts().begin(), source::all_parts().end());
        source::PartSet moved;
        std::set<std::string> names;
        for (const reference::Variant& other : variants_for(assignment, located, 4, 1)) {
            names.insert(other.name);
            for (const source::ScenePart part : source::parts_of(object)) {
                if (source::value_of(other.scene, part) != source::value_of(assignment.scene, part)) moved.insert(part);
            }
        }
        EXPECT_EQ(names.size(), 4U) << to_string(object);
        for (const source::ScenePart part : source::parts_of(object))
            EXPECT_TRUE(moved.contains(part)) << to_string(part);
    }
}

}  // namespace
}  // namespace harness::variants
