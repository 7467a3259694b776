#include "harness/grade/marking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace harness {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string error_of(const std::string& mistakes) {
    const auto file = reference::read_assignment_file("a6-2024", RAYGRADE_ASSIGNMENTS);
    try {
        make_marking(reference::parse_assignment(file.toml + "[rubric.mistakes]\n" + mistakes + "\n", "a.toml"));
    } catch (const reference::AssignmentError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Marking, TakesNamesOfMistakesInEitherSpelling) {
    for (const char* line : {"\"center forgotten\" = 1.0", "\"centre forgotten\" = 0", "\"not normalised\" = 0.5",
                             "\"cylinder.normal\" = {\"centre forgotten\" = 1.0}"})
        EXPECT_EQ(error_of(line), "no error") << line;
}

TEST(Marking, RefusesAPriceForNoMistake) {
    EXPECT_THAT(error_of("\"center forgoten\" = 1.0"),
                AllOf(HasSubstr("a.toml:"), HasSubstr("rubric.mistakes.center forgoten"),
                      HasSubstr("did you mean center forgotten")));
    EXPECT_THAT(error_of("\"cylinder.normal\" = {\"far root\" = 1.0}"), HasSubstr("is no mistake that has a name"));
    EXPECT_THAT(error_of("\"cylinder.n\" = {\"far root\" = 1.0}"), HasSubstr("is no item"));
    EXPECT_THAT(error_of("\"far root\" = 1.5"), HasSubstr("must be from 0 to 1"));
}

}  // namespace
}  // namespace harness
