#include "harness/report/exchange/roster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/harness/report/exchange/refusal.h"

namespace harness::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal_of_ids(std::string_view csv) {
    return refusal([&] { students_in(csv); });
}

TEST(StudentsInRoster, AreThoseOfItsIds) {
    EXPECT_THAT(students_in("name,id\n\"Lovelace, Ada\",s07\nBen,s08\n"), ElementsAre("s07", "s08"));
    EXPECT_THAT(students_in("Student,ID,SIS User ID\nPoints Possible,,\n\"Doe, Jane\",4711,jd\n"), ElementsAre("4711"));
    EXPECT_THAT(students_in("id;name\ns07;Lovelace, Ada\n"), ElementsAre("s07"));
    EXPECT_THAT(students_in("id,\"a; b; c\"\ns07,x\n"), ElementsAre("s07"));
    EXPECT_THAT(students_in("Identifier,Full name\nParticipant 12,Ada\nParticipant 9,Ben\n"), ElementsAre("12", "9"));
}

TEST(StudentsInRoster, AreNotGuessed) {
    EXPECT_THAT(refusal_of_ids(""), HasSubstr("no column id"));
    EXPECT_THAT(refusal_of_ids("name\nada\n"), HasSubstr("no column id"));
    EXPECT_THAT(refusal_of_ids("id\n"), HasSubstr("names no students"));
    EXPECT_THAT(refusal_of_ids("id\nada\nben\nada\n"), HasSubstr("line 4: ada stands twice"));
    EXPECT_THAT(refusal_of_ids("id\na\x1b[31m\n"), HasSubstr("line 2: the id is not printable"));
}

}  // namespace
}  // namespace harness::report
