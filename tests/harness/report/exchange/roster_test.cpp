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

std::vector<std::string> students(std::string_view csv) {
    std::vector<std::string> list;
    for (const RosterStudent& student : students_in(csv)) list.push_back(student.id + "=" + student.name);
    return list;
}

TEST(StudentsInRoster, AreThoseOfItsIdsWithTheirNames) {
    EXPECT_THAT(students("name,id\n\"Lovelace, Ada\",s07\nBen,s08\n"), ElementsAre("s07=Lovelace, Ada", "s08=Ben"));
    EXPECT_THAT(students("Student,ID,SIS User ID\nPoints Possible,,\n\"Doe, Jane\",4711,jd\n"),
                ElementsAre("4711=Doe, Jane"));
    EXPECT_THAT(students("id;name\ns07;Lovelace, Ada\n"), ElementsAre("s07=Lovelace, Ada"));
    EXPECT_THAT(students("id,\"a; b; c\"\ns07,x\n"), ElementsAre("s07="));
    EXPECT_THAT(students("Identifier,Full name\nParticipant 12,Ada\nParticipant 9,Ben\n"),
                ElementsAre("12=Ada", "9=Ben"));
}

TEST(StudentsInRoster, AreNotGuessed) {
    EXPECT_THAT(refusal_of_ids(""), HasSubstr("no column id"));
    EXPECT_THAT(refusal_of_ids("name\nada\n"), HasSubstr("no column id"));
    EXPECT_THAT(refusal_of_ids("id\n"), HasSubstr("names no students"));
    EXPECT_THAT(refusal_of_ids("id\nada\nben\nada\n"), HasSubstr("line 4: ada appears twice"));
    EXPECT_THAT(refusal_of_ids("id\na\x1b[31m\n"), HasSubstr("line 2: the id is not printable"));
}

}  // namespace
}  // namespace harness::report
