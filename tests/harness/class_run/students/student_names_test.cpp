#include "harness/class_run/students/student_names.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

Submission of_student(const std::string& id, const std::string& name, const std::string& number) {
    Submission one;
    one.id = id;
    one.name = name;
    one.lms = LmsName{};
    one.lms->id = number;
    return one;
}

StudentNames two_called_li() {
    StudentNames names;
    names.add(of_student("ekemil", "Ek, Emil", "1000"));
    names.add(of_student("liwei", "Li, Wei", "1001"));
    names.add(of_student("liwei-2", "Li, Wei", "1002"));
    return names;
}

TEST(StudentNames, LeadToTheIdIfOnlyOneStudentHasTheName) {
    EXPECT_EQ(two_called_li().id_of("Ek, Emil"), "ekemil");
    EXPECT_EQ(two_called_li().id_of("ekemil"), "ekemil");
    EXPECT_EQ(two_called_li().id_of("1000"), "1000");
    EXPECT_EQ(two_called_li().id_of("nobody"), "nobody");
    EXPECT_EQ(two_called_li().id_of("Li, Wei"), "Li, Wei") << "two are called so";
    EXPECT_EQ(two_called_li().count("Li, Wei"), 2U);
}

TEST(StudentNames, AreTheSameInEachFormOfUnicode) {
    StudentNames names;
    names.add(of_student("muller", "Mu\u0308ller", "1"));
    EXPECT_EQ(names.id_of("M\u00fcller"), "muller");
    EXPECT_EQ(names.id_of("Mu\u0308ller"), "muller");
}

TEST(StudentNames, CannotImpersonateAnotherStudent) {
    StudentNames names = two_called_li();
    names.add(of_student("mallory", "ekemil", "1003"));
    names.add(of_student("trudy", "1001", "1004"));
    EXPECT_EQ(names.id_of("ekemil"), "ekemil");
    EXPECT_EQ(names.id_of("1001"), "1001") << "the system's number of a different student";
}

TEST(StudentNames, AreReplacedByIdsInAList) {
    std::map<std::string, double> days{{"Ek, Emil", 2}, {"1001", 3}, {"liwei-2", 4}, {"nobody", 5}};
    two_called_li().go_by_ids(days);
    EXPECT_EQ(days, (std::map<std::string, double>{{"ekemil", 2}, {"1001", 3}, {"liwei-2", 4}, {"nobody", 5}}));
    std::map<std::string, double> twice{{"Ek, Emil", 2}, {"ekemil", 3}};
    two_called_li().go_by_ids(twice);
    EXPECT_EQ(twice, (std::map<std::string, double>{{"Ek, Emil", 2}, {"ekemil", 3}})) << "neither is lost unseen";
}

}  // namespace
}  // namespace harness
