#include "harness/variants/generate_variants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "reference/answer_key.h"
#include "reference/scene_toml.h"

namespace harness::variants {
namespace {

using reference::SceneVariant;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const reference::Assignment& assignment() {
    static const reference::Assignment a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    return a6;
}

PartSet every_part() {
    PartSet parts;
    for (const ScenePart part : all_parts) parts.insert(part);
    return parts;
}

reference::AnswerKey key_of(const SceneVariant& variant) {
    reference::Assignment other = assignment();
    other.scene = variant.scene;
    return reference::make_key(other, reference::Precision::certified);
}

TEST(VariantsFor, HasTheFourKindsWithTheirProperties) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto variants = variants_for(assignment(), every_part(), 4, seed);
        ASSERT_THAT(variants, SizeIs(4)) << "seed " << seed;
        EXPECT_EQ(key_of(variants[0]).decisions.sphere, "hit");
        EXPECT_EQ(key_of(variants[0]).decisions.triangle, "hit");
        EXPECT_EQ(key_of(variants[1]).decisions.first, "triangle");
        EXPECT_EQ(key_of(variants[1]).decisions.sphere, "hit");
        EXPECT_EQ(key_of(variants[2]).decisions.sphere, "miss");
        EXPECT_EQ(key_of(variants[3]).decisions.sphere, "hit");
        const auto d =
            std::get<reference::Numbers>(key_of(variants[3]).questions.at(5).items.at(3).answers.front().value);
        const double radius = value_of(variants[3].scene, ScenePart::radius)[0];
        EXPECT_LT(d.at(0), 0.5 * radius * radius) << "grazed: of the diameter less than 0.36 is within the sphere";
    }
}

TEST(VariantsFor, DiffersInEveryItemThatCanDiffer) {
    const reference::AnswerKey base = reference::make_key(assignment(), reference::Precision::certified);
    std::set<std::string> changed;
    for (const SceneVariant& variant : variants_for(assignment(), every_part(), 2, 1)) {
        const reference::AnswerKey key = key_of(variant);
        for (std::size_t q = 0; q < key.questions.size(); ++q) {
            for (std::size_t i = 0; i < key.questions[q].items.size(); ++i) {
                const auto& item = key.questions[q].items[i];
                if (item.answers.front().value != base.questions[q].items[i].answers.front().value)
                    changed.insert(std::to_string(key.questions[q].number) + "." + std::string(item.spec.name));
            }
        }
    }
    // V has length 1, so that a is 1 in every scene.
    EXPECT_EQ(changed.size(), 21U) << testing::PrintToString(changed);
    EXPECT_FALSE(changed.contains("6.a"));
}

TEST(VariantsFor, ChangesOnlyWhatWasLocated) {
    PartSet located;
    for (const ScenePart part : {ScenePart::eye, ScenePart::center}) located.insert(part);
    const auto variants = variants_for(assignment(), located, 4, 1);
    ASSERT_THAT(variants, SizeIs(4));
    for (const SceneVariant& variant : variants) {
        for (const ScenePart part : all_parts) {
            const bool changed = value_of(variant.scene, part) != value_of(assignment().scene, part);
            EXPECT_EQ(changed, located.contains(part)) << variant.name << ": " << to_string(part);
        }
    }
}

TEST(VariantsFor, MakesAKeyOfWhateverWasLocated) {
    for (unsigned bits = 1; bits < 1U << all_parts.size(); bits += 37) {
        PartSet located;
        for (std::size_t i = 0; i < all_parts.size(); ++i) {
            if ((bits >> i & 1U) != 0) located.insert(all_parts.at(i));
        }
        if (located.contains(ScenePart::A) != located.contains(ScenePart::B) ||
            located.contains(ScenePart::B) != located.contains(ScenePart::C))
            continue;
        for (const SceneVariant& variant : variants_for(assignment(), located, 4, bits))
            EXPECT_NO_THROW(key_of(variant));
    }
}

TEST(VariantsFor, IsTheSameForTheSameSeedAndAnotherForAnother) {
    const auto toml = [](std::uint64_t seed) {
        return reference::scene_toml(variants_for(assignment(), every_part(), 1, seed).at(0).scene);
    };
    EXPECT_EQ(toml(7), toml(7));
    EXPECT_NE(toml(7), toml(8));
}

TEST(VariantsFor, DrawsWholeNumbersThatAFloatHolds) {
    for (const SceneVariant& variant : variants_for(assignment(), every_part(), 8, 3)) {
        for (const ScenePart part : all_parts) {
            for (const double x : value_of(variant.scene, part)) {
                EXPECT_EQ(x, std::trunc(x));
                EXPECT_LT(std::abs(x), 1000);
            }
        }
    }
}

TEST(VariantsFor, IsEmptyWhereNothingWasLocated) {
    EXPECT_THAT(variants_for(assignment(), {}, 4, 1), IsEmpty());
}

TEST(VariantsFor, TakesTheAssignmentsOwnFirst) {
    reference::Assignment own = assignment();
    own.variants.push_back({"mine", own.scene});
    own.variants.back().scene.camera.eye.x = reference::Decimal::parse("3").value();
    own.variants.push_back({"into the eye", own.scene});
    own.variants.back().scene.camera.lookat = own.scene.camera.eye;
    own.variants.back().scene.camera.eye = own.scene.camera.lookat;
    PartSet located;
    located.insert(ScenePart::eye);
    const auto variants = variants_for(own, located, 2, 1);
    ASSERT_THAT(variants, SizeIs(2));
    EXPECT_EQ(variants[0].name, "mine");
    // With the eye alone moved it would lie in lookat.
    EXPECT_NE(variants[1].name, "into the eye");
}

}  // namespace
}  // namespace harness::variants
