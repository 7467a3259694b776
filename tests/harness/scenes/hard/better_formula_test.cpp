#include "harness/scenes/hard/better_formula.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "reference/accuracy/measure/measure.h"
#include "tests/given/hard_scenes/held.h"
#include "tests/given/student/printout.h"

namespace harness::scenes {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> formulas_for(const std::vector<HardItem>& lost, const student::Marking& marking) {
    return better_formulas(lost, {marking.assignment, marking.key});
}

TEST(BetterFormulas, AreNamedAsInTheMeasurement) {
    const student::Marking marking = far_sphere();
    const auto lost = losses_of(student::with_line(right_printout(marking), 6, "t", "100000.50"), marking);
    const auto sentences = formulas_for(lost, marking);
    ASSERT_FALSE(sentences.empty());
    EXPECT_THAT(sentences.front(), AllOf(Not(HasSubstr("naive quadratic float")), HasSubstr("Haines float keeps 15"),
                                         HasSubstr("naive quadratic double keeps 15")))
        << "a method that does no better is not named";
    EXPECT_THAT(formulas_for({}, marking), IsEmpty());
}

TEST(BetterFormulas, SayThatTheFormulaIsNotAtFault) {
    const student::Marking marking = held(student::scene_named("sphere missed"));
    EXPECT_THAT(formulas_for({{6, "t", Loss::miss_hit, 0, 0, ""}}, marking),
                ElementsAre("The formula is not at fault: naive quadratic float decides right here."));
}

TEST(BetterFormulas, AreNotToldOfWhatIsNotPrinted) {
    EXPECT_THAT(formulas_for({{6, "t", Loss::missing, 0, 0, ""}}, far_sphere()), IsEmpty());
    EXPECT_THAT(formulas_for({{4, "P_WCS", Loss::missing, 0, 0, ""}, {6, "t", Loss::digits, 2, 6, ""}}, far_sphere()),
                IsEmpty())
        << "the ray itself is not known";
}

/// A name without its scalar.
std::string kernel_of(const std::string& name) {
    for (const std::string scalar : {" float interval", " double-double", " 100 digits"}) {
        if (name.ends_with(scalar)) return name.substr(0, name.size() - scalar.size());
    }
    return name.substr(0, name.rfind(' '));
}

TEST(BetterFormulas, ExistForEveryMeasuredFormula) {
    // The formula of another method in the list, computed faster.
    const std::set<std::string> is_another_form{"half-b branch-free",
                                                "half-b decision",
                                                "half-b FMA",
                                                "half-b epsilon",
                                                "stable branch-free",
                                                "Cramer branch-free",
                                                "Cramer branch-free, prepared",
                                                "Cramer decision",
                                                "Cramer decision, prepared",
                                                "Cramer in pairs",
                                                "Möller-Trumbore decision",
                                                "Möller-Trumbore FMA",
                                                "Möller-Trumbore epsilon",
                                                "Havel-Herout, prepared",
                                                "Plücker, prepared"};
    for (const auto primitive : {reference::accuracy::Primitive::sphere, reference::accuracy::Primitive::triangle}) {
        for (const std::string& name : reference::accuracy::method_names(primitive)) {
            const std::string kernel = kernel_of(name);
            const bool is_own = name.starts_with("certified") || name.starts_with("conservative") ||
                                name.starts_with("interval filter") || name.starts_with("Shewchuk");
            EXPECT_EQ(formula_of(kernel).empty(), is_own || is_another_form.count(kernel) > 0) << name;
        }
    }
}

}  // namespace
}  // namespace harness::scenes
