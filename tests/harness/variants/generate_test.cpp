#include "harness/variants/generate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "harness/source/scene/part_name.h"
#include "harness/source/scene/scene_part.h"
#include "harness/variants/random/draw.h"
#include "reference/key/answer_key.h"
#include "reference/toml/scene_toml.h"
#include "tests/given/cases.h"

namespace harness::variants {
namespace {

using reference::Variant;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const reference::Assignment& assignment() {
    static const reference::Assignment a6 = reference::load_assignment("a6-2021", RAYGRADE_ASSIGNMENTS);
    return a6;
}

source::PartSet every_part() {
    source::PartSet parts;
    for (const source::ScenePart part : source::all_parts()) parts.insert(part);
    return parts;
}

reference::AnswerKey key_of(const Variant& variant) {
    reference::Assignment other = assignment();
    other.scene = variant.scene;
    return reference::make_key(other, reference::Precision::certified);
}

/// The first number of an item of question 6 or 8 in the key.
double number_of(const reference::AnswerKey& key, int question, std::string_view name) {
    for (const auto& item : key.questions.at(static_cast<std::size_t>(question - 1)).items) {
        if (item.spec.name == name) return std::get<reference::Numbers>(item.answers.front().value).at(0);
    }
    throw std::logic_error("no such item");
}

/// V has length 1, so d = 4 (R^2 - distance^2) gives the distance between the ray and the sphere's centre.
TEST(VariantsFor, GivesTheFourKindsWithTheirProperties) {
    for (std::uint64_t seed = 1; seed <= cases(2); ++seed) {
        SCOPED_TRACE(seed);
        const auto variants = variants_for(assignment(), every_part(), 4, seed);
        ASSERT_THAT(variants, SizeIs(4));
        std::vector<reference::AnswerKey> keys;
        std::vector<double> shares;
        for (const Variant& variant : variants) {
            keys.push_back(key_of(variant));
            const double radius = source::value_of(variant.scene, source::part::sphere::radius)[0];
            shares.push_back(number_of(keys.back(), 6, "d") / (4 * radius * radius));
            EXPECT_EQ(keys.back().decisions.of(reference::Subject::triangle), "hit");
        }
        const auto lead = [&](std::size_t i) { return number_of(keys[i], 6, "t") - number_of(keys[i], 8, "t"); };
        EXPECT_GT(shares[0], 0.2);
        EXPECT_GT(std::abs(lead(0)), 0.3) << "no float mistakes the order";
        EXPECT_GT(shares[1], 0.2);
        EXPECT_GT(lead(1), 0.3) << "the triangle is in front";
        EXPECT_EQ(keys[1].decisions.first, "triangle");
        EXPECT_LT(shares[2], -0.2);
        EXPECT_EQ(keys[2].decisions.of(reference::Subject::sphere), "miss");
        EXPECT_GT(shares[3], 0.005) << "grazed, but hit";
        EXPECT_LT(shares[3], 0.12);
        EXPECT_EQ(keys[3].decisions.of(reference::Subject::sphere), "hit");
        for (const reference::AnswerKey& key : keys) {
            const double u = number_of(key, 8, "u"), v = number_of(key, 8, "v");
            EXPECT_GT(std::min({u, v, 1 - u - v}), 0.05) << "not at an edge";
        }
    }
}

TEST(VariantsFor, DiffersInEveryItemThatCanDiffer) {
    const reference::AnswerKey base = reference::make_key(assignment(), reference::Precision::certified);
    std::set<std::string> changed;
    for (const Variant& variant : variants_for(assignment(), every_part(), 2, 1)) {
        const reference::AnswerKey key = key_of(variant);
        for (std::size_t q = 0; q < key.questions.size(); ++q) {
            for (std::size_t i = 0; i < key.questions[q].items.size(); ++i) {
                const auto& item = key.questions[q].items[i];
                if (item.answers.front().value != base.questions[q].items[i].answers.front().value)
                    changed.insert(std::to_string(key.questions[q].number) + "." + std::string(item.spec.name));
            }
        }
    }
    // V has length 1, so a is 1 in every scene.
    EXPECT_EQ(changed.size(), 21U) << testing::PrintToString(changed);
    EXPECT_FALSE(changed.contains("6.a"));
}

TEST(VariantsFor, ChangesOnlyLocatedParts) {
    for (const std::vector<source::ScenePart>& parts : {std::vector{source::part::eye, source::part::sphere::center},
                                                        {source::part::sphere::radius, source::part::lookat},
                                                        {source::part::vup}}) {
        source::PartSet located;
        for (const source::ScenePart part : parts) located.insert(part);
        const auto variants = variants_for(assignment(), located, 4, 1);
        ASSERT_THAT(variants, SizeIs(4));
        for (const Variant& variant : variants) {
            source::PartSet changed;
            for (const source::ScenePart part : source::all_parts()) {
                if (!source::has_part(variant.scene, part)) continue;
                if (source::value_of(variant.scene, part) == source::value_of(assignment().scene, part)) continue;
                changed.insert(part);
                EXPECT_TRUE(located.contains(part)) << variant.name << ": " << to_string(part);
            }
            EXPECT_FALSE(changed.empty()) << variant.name;
        }
    }
}

TEST(VariantsFor, GivesAKeyForAnyLocatedParts) {
    for (unsigned bits = 1; bits < 1U << source::all_parts().size(); bits += 977) {
        source::PartSet located;
        for (std::size_t i = 0; i < source::all_parts().size(); ++i) {
            if ((bits >> i & 1U) != 0) located.insert(source::all_parts().at(i));
        }
        if (located.contains(source::part::triangle::A) != located.contains(source::part::triangle::B) ||
            located.contains(source::part::triangle::B) != located.contains(source::part::triangle::C))
            continue;
        for (const Variant& variant : variants_for(assignment(), located, 4, bits)) EXPECT_NO_THROW(key_of(variant));
    }
}

TEST(VariantsFor, LeaveAClearAnswerToATriangleThatStays) {
    const source::PartSet located{source::part::eye, source::part::lookat, source::part::vup,
                                  source::part::sphere::center, source::part::sphere::radius};
    const auto edge_to = [&](source::ScenePart to) {
        const auto a = source::value_of(assignment().scene, source::part::triangle::A),
                   b = source::value_of(assignment().scene, to);
        return reference::Vec3<double>(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    };
    const auto normal =
        reference::normalized(reference::cross(edge_to(source::part::triangle::B), edge_to(source::part::triangle::C)));
    for (std::uint64_t seed = 1; seed <= cases(2); ++seed) {
        SCOPED_TRACE(seed);
        const auto variants = variants_for(assignment(), located, 4, seed);
        ASSERT_THAT(variants, SizeIs(4));
        for (const Variant& variant : variants) {
            const auto ray = reference::answer_camera(in_double(variant.scene), reference::PixelConvention::centre);
            EXPECT_GT(std::abs(reference::dot(ray.V, normal)), 0.02) << "the ray is not parallel to it";
            EXPECT_EQ(key_of(variant).decisions.of(reference::Subject::triangle), "hit") << "as in the assignment";
        }
    }
}

TEST(VariantsFor, IsDeterminedByTheSeed) {
    const auto toml = [](std::uint64_t seed) {
        return reference::scene_toml(variants_for(assignment(), every_part(), 1, seed).at(0).scene);
    };
    EXPECT_EQ(toml(7), toml(7));
    EXPECT_NE(toml(7), toml(8));
}

TEST(VariantsFor, DrawsWholeNumbersThatAFloatHolds) {
    for (const Variant& variant : variants_for(assignment(), every_part(), 8, 3)) {
        for (const source::ScenePart part : source::all_parts()) {
            if (!source::has_part(variant.scene, part)) continue;
            for (const double x : source::value_of(variant.scene, part)) {
                EXPECT_EQ(x, std::trunc(x));
                EXPECT_LT(std::abs(x), 1000);
            }
        }
    }
}

TEST(VariantsFor, IsEmptyIfNothingWasLocated) {
    EXPECT_THAT(variants_for(assignment(), {}, 4, 1), IsEmpty());
}

TEST(VariantsFor, TakesTheAssignmentsOwnScenesFirst) {
    reference::Assignment own = assignment();
    own.variants.push_back({"mine", own.scene});
    own.variants.back().scene.camera.eye.x = reference::Decimal::parse("3").value();
    own.variants.push_back({"into the eye", own.scene});
    own.variants.back().scene.camera.lookat = own.scene.camera.eye;
    own.variants.back().scene.camera.eye = own.scene.camera.lookat;
    own.variants.insert(own.variants.begin(), {"another radius", assignment().scene});
    own.variants.front().scene.spheres.front().radius = reference::Decimal::parse("3").value();
    source::PartSet located;
    located.insert(source::part::eye);
    const auto variants = variants_for(own, located, 2, 1);
    ASSERT_THAT(variants, SizeIs(2));
    EXPECT_EQ(variants[0].name, "mine") << "with the eye alone the first would be the assignment's own scene";
    // If only the eye were moved, it would coincide with lookat.
    EXPECT_NE(variants[1].name, "into the eye");
}

}  // namespace
}  // namespace harness::variants
