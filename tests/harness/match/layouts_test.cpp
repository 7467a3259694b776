// The same answers get the same marks in any layout. A failing trial prints its seed, which is the trial's number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "harness/mark/score/mark_transcript.h"
#include "tests/given/cases.h"
#include "tests/given/random_scene.h"
#include "tests/given/student/mistakes.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"

namespace {

using namespace harness;
using reference::ItemId;
using student::Layout;
using student::Program;
using student::Way;

const std::uint64_t trials = cases(240);
constexpr int max_failures = 3;  // printed in full

Way random_way(std::uint64_t seed) {
    constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}};
    std::mt19937_64 random(seed ^ 0x5bd1e995U);
    Way way;
    way.arithmetic = static_cast<Way::Arithmetic>(random() % 3);
    way.convention = random() % 4 == 0 ? reference::PixelConvention::grid : reference::PixelConvention::centre;
    way.boundary = random() % 2 == 0 ? reference::Boundary::positive : reference::Boundary::nonnegative;
    way.half_b = random() % 4 == 0;
    const auto& order = orders[random() % 6];
    way.columns.assign(order, order + 3);
    way.true_hits_only = random() % 2 == 0;
    way.quadratic_factor = random() % 8 == 0 ? -2.0F : 1.0F;
    if (random() % 8 == 0) way.row_factors = {-1.0F, 2.0F, 1.0F};
    return way;
}

Score mark(const std::string& output, const student::Marking& marking) {
    return score(read_transcript(output, last_question(marking.assignment.questions)), marking.key, marking.assignment);
}

std::string lost_items(const Score& score) {
    std::string text;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            if (item.verdict == ItemVerdict::right) continue;
            text += std::to_string(question.number) + "." + std::string(item.spec.name) + " is " +
                    std::string(to_string(item.verdict)) + ": " + item.printed + "\n";
        }
    }
    return text;
}

class Layouts : public testing::TestWithParam<std::string_view> {};

TEST_P(Layouts, GetFullMarksForRightAnswers) {
    const student::Marking marking = student::scene_named(GetParam());
    int failures = 0;
    for (std::uint64_t seed = 1; seed <= trials && failures < max_failures; ++seed) {
        const Layout layout = student::random_layout(seed, 2);
        Way way = random_way(seed);
        if (GetParam() == "along the axis") way.quadratic_factor = 1;  // a and b are 0, so c alone cannot tell it
        const Program program(marking.assignment, way);
        const std::string output = print(program, layout);
        const std::string lost = lost_items(mark(output, marking));
        EXPECT_EQ(lost, "") << layout.describe() << "\n" << output;
        if (!lost.empty()) ++failures;
    }
}

std::string test_name(const testing::TestParamInfo<std::string_view>& info) {
    std::string name(info.param);
    std::replace(name.begin(), name.end(), ' ', '_');
    std::erase(name, ',');
    return name;
}

TEST(LayoutsOfRandomScenes, GetFullMarksForRightAnswers) {
    int failures = 0;
    for (std::uint64_t seed = 1; seed <= cases(40) && failures < max_failures; ++seed) {
        reference::Assignment assignment = random_assignment(seed);
        const student::Marking marking{assignment, make_key(assignment, reference::Precision::certified)};
        for (std::uint64_t layout_seed = 3 * seed; layout_seed < 3 * seed + 3; ++layout_seed) {
            const Layout layout = student::random_layout(layout_seed, 2);
            const std::string output = print(Program(assignment, random_way(layout_seed)), layout);
            const std::string lost = lost_items(mark(output, marking));
            EXPECT_EQ(lost, "") << "scene " << seed << ", " << layout.describe() << "\n" << output;
            if (!lost.empty()) ++failures;
        }
    }
}

/// A mistake in any item: its stage is computed wrongly, or one of its numbers is changed.
struct Planted {
    Program::Mistake mistake;
    std::string name;
};

Planted random_mistake(std::uint64_t seed, const Program& right) {
    std::mt19937_64 random(seed);
    if (random() % 2 == 0) {
        std::vector<student::NamedMistake> named;
        for (const student::NamedMistake& each : student::named_mistakes()) {
            if (std::ranges::count(right.asked(), each.mistake.item, &reference::ItemSpec::id) > 0)
                named.push_back(each);
        }
        const student::NamedMistake& chosen = named[random() % named.size()];
        return {chosen.mistake, std::string(chosen.name)};
    }
    std::vector<ItemId> numeric;
    for (const reference::ItemSpec& spec : right.asked()) {
        if (spec.shape != reference::Shape::first_object) numeric.push_back(spec.id);
    }
    const ItemId id = numeric[random() % numeric.size()];
    const std::uint64_t component = random();
    const auto alter = [=](const Program&, const std::optional<student::Floats>& correct) {
        std::optional<student::Floats> value = correct;
        if (!value) return value;
        float& x = (*value)[component % value->size()];
        x = x * 1.375F + 0.25F;
        return value;
    };
    return {{id, alter}, "altered"};
}

bool is_finite(const Program& program) {
    for (const auto& [id, value] : program.values()) {
        if (value && !std::all_of(value->begin(), value->end(), [](float x) { return std::isfinite(x); })) return false;
    }
    return true;
}

/// Whether the printed digits of b and c do not determine the discriminant, because too many digits cancel, or do not
/// show whether b is halved, because too few cancel.
bool cancels(const Program& program) {
    return std::ranges::any_of(reference::objects, [&](const reference::Subject object) {
        if (!program.has({object, "d"})) return false;
        const float b = program.scalar({object, "b"});
        const float ac = program.scalar({object, "a"}) * program.scalar({object, "c"});
        return std::abs(b * b - 4 * ac) < 0.01F * b * b || std::abs(ac) < 0.01F * b * b;
    });
}

/// The program with the mistake; empty if the scene has no such item (e.g. no hit point), or if the mistake gives no
/// value, from which nothing follows, or no finite numbers.
std::optional<Program> make_mistake(const student::Marking& marking, const Way& way, const Program::Mistake& mistake) {
    try {
        Program program(marking.assignment, way, mistake);
        return program.has(mistake.item) && is_finite(program) && !cancels(program) ? std::optional(std::move(program))
                                                                                    : std::nullopt;
    } catch (const std::bad_optional_access&) {
        return std::nullopt;
    }
}

/// Whether two values differ so much that neither digits nor roundings can make them look alike.
bool differs_clearly(const std::optional<student::Floats>& one, const std::optional<student::Floats>& other,
                     double allowance) {
    if (one.has_value() != other.has_value()) return true;
    if (!one) return false;
    for (std::size_t i = 0; i < one->size(); ++i) {
        if (std::abs((*one)[i] - (*other)[i]) > 2 * allowance + 0.02F * std::max(1.0F, std::abs((*other)[i])))
            return true;
    }
    return false;
}

/// What is wrong with the marks of a program with one mistake; "" if nothing is wrong.
std::string unjust_verdicts(const Score& score, const Program& wrong, const Program& right, const ItemId& mistake,
                            bool is_decided) {
    std::string text;
    for (const QuestionScore& question : score.questions) {
        for (const ItemScore& item : question.items) {
            const ItemId& id = item.spec.id;
            const bool is_first_object = item.spec.shape == reference::Shape::first_object;
            const bool same = is_first_object ? wrong.first_object() == right.first_object()
                                              : wrong.values().at(id) == right.values().at(id);
            const bool different = !is_first_object && differs_clearly(wrong.values().at(id), right.values().at(id),
                                                                       item.allowance.value_or(0));
            std::string fair = "right or follow";
            const bool no_value = !is_first_object && (!wrong.values().at(id) || !right.values().at(id));
            // Behind the start the point of the triangle's plane is right too.
            const bool may_be_of_plane = no_value && id == reference::item::triangle::hit;
            if (id == mistake)
                fair = "wrong";
            else if (no_value && (!is_decided || may_be_of_plane))
                fair = "right or follow";
            else if (same)
                fair = "right";
            else if (different)
                fair = "follow";
            if (fair.find(to_string(item.verdict)) != std::string::npos) continue;
            text += fmt::format("{}.{} is {}, not {}: {} (accepted as '{}', allowance {})\n", question.number,
                                item.spec.name, to_string(item.verdict), fair, item.printed, item.accepted_as,
                                item.allowance.value_or(0));
        }
    }
    return text;
}

/// Whether every right program has the same hits on this scene: the rubric accepts only one reading of t = 0, and no
/// rounding matters.
bool is_decided(const student::Marking& marking) {
    const std::string& name = marking.assignment.name;
    return !name.starts_with("barely") && !name.starts_with("almost") && name != "grazing" && name != "a6-2021" &&
           name != "a6-edge";
}

/// On the handout's scene the row of V has no other entries, so the mistake only multiplies both its sides by -1.
bool is_equivalent(const student::Marking& marking, const Planted& planted) {
    return marking.assignment.name == "a6-2021" && planted.name == "V not negated";
}

class SingleMistakes : public Layouts {};

TEST_P(SingleMistakes, LoseOnlyTheirItem) {
    const student::Marking marking = student::scene_named(GetParam());
    int failures = 0;
    std::uint64_t tried = 0;
    for (std::uint64_t seed = 1; seed <= trials && failures < max_failures; ++seed) {
        Way way = random_way(seed);
        const Planted planted = random_mistake(seed, Program(marking.assignment, way));
        const auto& [subject, name] = planted.mistake.item;
        const bool is_in_quadratic =
            name != "normal" && (subject == reference::Subject::sphere || subject == reference::Subject::cylinder);
        way.convention = reference::PixelConvention::centre;
        way.half_b = way.half_b && !is_in_quadratic;
        way.quadratic_factor = 1;
        way.row_factors = {1, 1, 1};
        if (planted.mistake.item == reference::item::triangle::matrix) way.columns = {0, 1, 2};
        const Program right(marking.assignment, way);
        const std::optional<Program> wrong = make_mistake(marking, way, planted.mistake);
        const auto& id = planted.mistake.item;
        // One t of two objects decides no order if it is wrong for one of them.
        const bool is_wrong_tie = wrong && wrong->first_object() == reference::FirstObject::tie &&
                                  right.first_object() != reference::FirstObject::tie;
        if (!wrong || !right.has(id) || is_wrong_tie || is_equivalent(marking, planted) ||
            !differs_clearly(wrong->values().at(id), right.values().at(id), 0))
            continue;
        ++tried;
        Layout layout = student::random_layout(seed, 6);
        // For numbers of about 1e9, seven digits leave several per cent of a discriminant of 1e5 open; six decimals
        // leave as much of coefficients of about 1e-5.
        if (GetParam().starts_with("large") || GetParam().starts_with("small")) {
            layout.format = student::NumberFormat::scientific;
            layout.digits = 8;
        }

        const std::string output = print(*wrong, layout);
        const std::string unjust = unjust_verdicts(mark(output, marking), *wrong, right, id, is_decided(marking));
        EXPECT_EQ(unjust, "") << planted.name << " in " << to_string(id.subject) << "." << id.name << ", "
                              << layout.describe() << "\n"
                              << output;
        if (!unjust.empty()) ++failures;
    }
    EXPECT_GE(tried, trials / 5 * 2);
}

/// Where rounding decides what the ray hits, a mistake may give another right answer.
std::vector<std::string_view> scenes_where_mistakes_show() {
    std::vector<std::string_view> names = student::scene_names();
    for (const std::string_view name : student::cylinder_scene_names()) {
        if (!student::rounding_decides(name)) names.push_back(name);
    }
    return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Layouts, testing::ValuesIn(student::scene_names()), test_name);
INSTANTIATE_TEST_SUITE_P(CylinderScenes, Layouts, testing::ValuesIn(student::cylinder_scene_names()), test_name);
INSTANTIATE_TEST_SUITE_P(Scenes, SingleMistakes, testing::ValuesIn(scenes_where_mistakes_show()), test_name);

}  // namespace
