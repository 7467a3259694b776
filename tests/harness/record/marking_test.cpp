#include "harness/record/marking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "reference/key/key_formats.h"
#include "reference/toml/assignment_error.h"
#include "tests/given/message_of.h"

namespace harness {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string error_of(const std::string& mistakes) {
    const auto file = reference::read_assignment_file("a6-2024", RAYGRADE_ASSIGNMENTS);
    const std::string toml = file.toml + "[rubric.mistakes]\n" + mistakes + "\n";
    return message_of<reference::AssignmentError>([&] { make_marking(reference::parse_assignment(toml, "a.toml")); },
                                                  "no error");
}

TEST(Marking, TakesNamesOfMistakesInEitherSpelling) {
    for (const char* line : {"\"center forgotten\" = 1.0", "\"centre forgotten\" = 0", "\"not normalised\" = 0.5",
                             "\"cylinder.normal\" = {\"centre forgotten\" = 1.0}"})
        EXPECT_EQ(error_of(line), "no error") << line;
}

TEST(Marking, RefusesAPriceForAnUnknownMistake) {
    EXPECT_THAT(error_of("\"center forgoten\" = 1.0"),
                AllOf(HasSubstr("a.toml:"), HasSubstr("rubric.mistakes.center forgoten"),
                      HasSubstr("did you mean center forgotten")));
    EXPECT_THAT(error_of("\"cylinder.normal\" = {\"far root\" = 1.0}"), HasSubstr("unknown mistake"));
    EXPECT_THAT(error_of("\"cylinder.n\" = {\"far root\" = 1.0}"), HasSubstr("is not an item"));
    EXPECT_THAT(error_of("\"far root\" = 1.5"), HasSubstr("must be from 0 to 1"));
}

Marking of_two_students() {
    const auto file = reference::read_assignment_file("a6-2021", RAYGRADE_ASSIGNMENTS);
    return make_class_marking(reference::parse_assignment(
        file.toml + "[[student]]\nid = \"7\"\nsphere.radius = 2.5\n[[student]]\nid = \"ada\"\nsphere.radius = 3\n",
        "a.toml"));
}

std::string radius_for(const Marking& marking, const std::string& id, const std::string& lms_id) {
    Submission submission;
    submission.id = id;
    if (!lms_id.empty()) {
        submission.lms.emplace();
        submission.lms->id = lms_id;
    }
    return own_marking(marking, submission).assignment.scene.spheres.front().radius.text();
}

TEST(Marking, IsSeparateForEachStudentIfScenesAreDealt) {
    const Marking marking = of_two_students();
    EXPECT_EQ(radius_for(marking, "ada", ""), "3");
    EXPECT_EQ(radius_for(marking, "ada", "7"), "2.5") << "the number in the learning management system goes first";
    EXPECT_EQ(radius_for(marking, "ada", "8"), "3");
    EXPECT_EQ(radius_for(marking, "zoe", ""), "2") << "the class's, for want of another";
    Submission ada;
    ada.id = "ada";
    const Marking& own = own_marking(marking, ada);
    EXPECT_NE(reference::to_json(own.key), reference::to_json(marking.key));
    EXPECT_EQ(own.assignment.name, "a@ada");
}

TEST(Marking, RefusesAnAssignmentThatDealsSeveralScenes) {
    EXPECT_THAT([] { make_marking(of_two_students().assignment); },
                ThrowsMessage<reference::AssignmentError>(HasSubstr("e.g. a.toml@7")));
}

}  // namespace
}  // namespace harness
