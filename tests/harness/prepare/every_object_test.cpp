// What a new kind of object must have before a class is marked on it: reference/README.md, "Adding an object".
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/mark/diagnose/derivation.h"
#include "harness/mark/diagnose/mistakes.h"
#include "harness/match/vocabulary.h"
#include "harness/read/verdict.h"

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
        if (spec.shape == reference::Shape::verdict) continue;
        EXPECT_FALSE(names_of(spec).names.empty()) << spec.label;
    }
}

TEST(EveryObject, MayBeHitFirst) {
    std::vector<reference::Verdict> verdicts;
    for (const Subject object : reference::objects) {
        const std::string sentence = "ray hits " + std::string(reference::to_string(object)) + " first";
        const auto verdict = read_verdict({{sentence, 1}}, VerdictPlace::own_section);
        ASSERT_TRUE(verdict) << sentence;
        EXPECT_EQ(std::ranges::count(verdicts, verdict->verdict), 0) << sentence;
        verdicts.push_back(verdict->verdict);
    }
}

TEST(EveryObject, IsFollowedFromTheRayToTheHit) {
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
