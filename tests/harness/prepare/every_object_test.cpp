// What a new kind of object must have before a class is marked on it: reference/adding-an-object.md.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/mark/diagnose/derivations.h"
#include "harness/mark/diagnose/mistakes.h"
#include "harness/match/vocabulary.h"
#include "harness/read/first_object.h"

namespace harness {
namespace {

using reference::Subject;

TEST(EveryObject, HasWordsForItsItems) {
    const reference::Question all{1, "everything", [] {
                                      std::vector<ItemId> ids;
                                      for (const auto& item : reference::known_items()) ids.push_back(item.id);
                                      return ids;
                                  }()};
    for (const reference::ItemSpec& spec : reference::asked_items({all})) {
        if (spec.shape == reference::Shape::first_object) continue;
        EXPECT_FALSE(names_of(spec).names.empty()) << spec.label;
    }
}

TEST(EveryObject, CanBeHitFirst) {
    std::vector<reference::FirstObject> seen;
    for (const Subject object : reference::objects) {
        const std::string sentence = "ray hits " + std::string(reference::to_string(object)) + " first";
        const auto read = read_first_object({{sentence, 1}}, FirstObjectPlace::own_section);
        ASSERT_TRUE(read) << sentence;
        EXPECT_EQ(std::ranges::count(seen, read->object), 0) << sentence;
        seen.push_back(read->object);
    }
}

TEST(EveryObject, HasDerivationsFromTheRayToTheHit) {
    for (const Subject object : reference::objects) {
        for (const std::string_view name : {"t", "hit"}) {
            const auto gives = [&](const Derivation& derivation) { return derivation.item == ItemId{object, name}; };
            EXPECT_TRUE(std::ranges::any_of(all_derivations(), gives)) << reference::to_string(object) << "." << name;
        }
    }
}

TEST(EveryObject, HasNamedMistakes) {
    for (const Subject object : reference::objects) {
        EXPECT_GE(std::ranges::count_if(all_mistakes(),
                                        [&](const Mistake& mistake) { return mistake.item.subject == object; }),
                  5)
            << reference::to_string(object);
    }
}

}  // namespace
}  // namespace harness
