#include "harness/experiment/identify/identify.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/student/items.h"
#include "tests/given/student/mistakes.h"
#include "tests/harness/experiment/identify/student_on_scenes.h"

namespace harness::experiment {
namespace {

using student::Program;
using testing::HasSubstr;

const StudentOnScenes& student_off_axis() {
    static const StudentOnScenes student("off axis");
    return student;
}

std::string list(const Program& program, const reference::ItemId& id) {
    const auto& value = program.values().at(id);
    if (!value) return "none";
    std::string text;
    for (const float x : *value) text += fmt::format("{}{:f}", text.empty() ? "" : " ~ ", x);
    return text;
}

/// The items of question 6 and 8 under headings, each line as `line` prints it, and the verdict.
struct Printed {
    std::function<std::string(const Program&, const reference::ItemId&)> line;
    std::function<std::string(const Program&)> verdict = [](const Program& program) {
        return reference::sentence(program.first_object());
    };
    std::string end = {};

    std::string operator()(const Program& program) const {
        std::string text = "Question 6\n";
        for (const auto& id : {student::a, student::b, student::c, student::d, student::t_s, student::hit_s})
            text += line(program, id);
        text += "Question 8\n";
        for (const auto& id : {student::rhs, student::t_t, student::u, student::v, student::hit_t})
            text += line(program, id);
        return text + "Question 10\n" + verdict(program) + "\n" + end;
    }
};

const ItemScore& item(const Score& score, int question, std::string_view name) {
    for (const QuestionScore& each : score.questions) {
        for (const ItemScore& scored : each.items) {
            if (each.number == question && scored.spec.name == name) return scored;
        }
    }
    throw std::logic_error("no such item");
}

/// No words tell which number is one that stands beside another.
std::string arrow(const Program& program, const reference::ItemId& id) {
    if (program.values().at(id)->size() == 1) return fmt::format("{} 2 {}\n", list(program, id), id.name);
    return fmt::format("{} ==> {}\n", id.name, list(program, id));
}

TEST(Identify, FindsNumbersWhateverIsPrintedBesideThem) {
    const auto result = student_off_axis().run(Printed{arrow});
    for (const char* name : {"b", "c", "d", "t"}) {
        EXPECT_NE(item(result.before, 6, name).verdict, ItemVerdict::right) << name << ": there is nothing to find";
        EXPECT_EQ(item(result.after, 6, name).verdict, ItemVerdict::right) << name;
        EXPECT_FALSE(item(result.after, 6, name).doubt) << name;
    }
    EXPECT_THAT(item(result.after, 6, "t").experiment, HasSubstr("Line 6 was read as t because it changes as t does"));
}

TEST(Identify, SettlesThatAnItemIsNotPrinted) {
    const auto result = student_off_axis().run(Printed{[](const Program& program, const reference::ItemId& id) {
        return id == student::d ? "" : arrow(program, id);
    }});
    EXPECT_EQ(item(result.after, 6, "d").verdict, ItemVerdict::missing);
    EXPECT_FALSE(item(result.after, 6, "d").doubt);
    EXPECT_THAT(item(result.after, 6, "d").experiment, HasSubstr("Nothing printed changes as d does"));
}

TEST(Identify, IgnoresALineThatSaysItIsNotAnAnswer) {
    for (const char* words : {"debug", "expected", "check"}) {
        const auto result = student_off_axis().run(Printed{[&](const Program& program, const reference::ItemId& id) {
            if (id != student::t_s) return arrow(program, id);
            return fmt::format("{} value ==> {}\nt ==> {:f}\n", words, list(program, id), program.scalar(id) + 1);
        }});
        EXPECT_NE(item(result.after, 6, "t").verdict, ItemVerdict::right) << words;
    }
}

TEST(Identify, IgnoresANumberLabeledAsAnotherItemOfTheQuestion) {
    const auto result = student_off_axis().run(Printed{[](const Program& program, const reference::ItemId& id) {
        const auto exchanged = id == student::u ? student::v : id == student::v ? student::u : id;
        if (id == student::u || id == student::v) return fmt::format("{} = {}\n", id.name, list(program, exchanged));
        return arrow(program, id);
    }});
    EXPECT_EQ(item(result.after, 8, "u").verdict, ItemVerdict::wrong);
    EXPECT_EQ(item(result.after, 8, "v").verdict, ItemVerdict::wrong);
    EXPECT_EQ(item(result.after, 8, "t").verdict, ItemVerdict::right);
}

TEST(Identify, TakesNoOtherNumberIfOneHasTheItemsName) {
    const auto result = student_off_axis().run(Printed{[](const Program& program, const reference::ItemId& id) {
        if (id != student::t_s) return arrow(program, id);
        return fmt::format("t = {:f}\nzork ==> {}\n", program.scalar(id) + 1, list(program, id));
    }});
    EXPECT_EQ(item(result.after, 6, "t").verdict, ItemVerdict::wrong);
    EXPECT_TRUE(item(result.after, 6, "t").doubt) << "a person should look";
}

TEST(Identify, FindsConsistentAnswersAndNamedMistakes) {
    const auto mistake =
        std::ranges::find(student::named_mistakes(), "radius not squared", &student::NamedMistake::name);
    ASSERT_NE(mistake, student::named_mistakes().end());
    const auto result = student_off_axis().run(Printed{arrow}, {}, mistake->mistake);
    const reference::ItemId wrong = mistake->mistake.item;
    EXPECT_EQ(item(result.after, 6, wrong.name).verdict, ItemVerdict::wrong);
    EXPECT_EQ(item(result.after, 6, wrong.name).diagnosis, mistake->name);
    EXPECT_THAT(item(result.after, 6, wrong.name).experiment, HasSubstr("because it changes"));
    EXPECT_EQ(item(result.after, 6, "d").verdict, ItemVerdict::follow);
}

TEST(Identify, ReadsASignApartFromItsDigits) {
    const auto result = student_off_axis().run(Printed{[](const Program& program, const reference::ItemId& id) {
        if (id != student::b) return arrow(program, id);
        const float b = program.scalar(id);
        return fmt::format("zork ~ {} '{:f}'\n", b < 0 ? "-" : "+", std::abs(b));
    }});
    EXPECT_EQ(item(result.after, 6, "b").verdict, ItemVerdict::right);
}

TEST(Identify, FindsVectorsSideBySide) {
    const auto result = student_off_axis().run(Printed{[](const Program& program, const reference::ItemId& id) {
        if (id == student::hit_t) return std::string();
        if (id != student::rhs) return arrow(program, id);
        std::string rows;
        for (int i = 0; i < 3; ++i)
            rows += fmt::format("{:f} @ {:f}\n", program.vector(student::rhs)[i], program.vector(student::hit_t)[i]);
        return rows;
    }});
    EXPECT_EQ(item(result.after, 8, "rhs").verdict, ItemVerdict::right);
    EXPECT_EQ(item(result.after, 8, "hit").verdict, ItemVerdict::right);
}

TEST(Identify, FindsAnswersAmongTheNumbersOfOneThatIsRightByLuck) {
    static const StudentOnScenes on_handout("handout");
    const auto axes_in_columns = [](const Program& program) {
        std::string text = "Question 2\n";  // the second row is Y too where the axes are those of the world
        for (int i = 0; i < 3; ++i) {
            text += fmt::format("{:f}, {:f}, {:f}\n", program.vector(student::Z)[i], program.vector(student::Y)[i],
                                program.vector(student::X)[i]);
        }
        return text;
    };
    const auto result = on_handout.run(axes_in_columns);
    EXPECT_EQ(item(result.before, 2, "Y_vcs").verdict, ItemVerdict::right);
    EXPECT_EQ(item(result.before, 2, "X_vcs").verdict, ItemVerdict::wrong);
    for (const std::string_view name : {"X_vcs", "Y_vcs", "Z_vcs"}) {
        EXPECT_EQ(item(result.after, 2, name).verdict, ItemVerdict::right) << name;
        EXPECT_FALSE(item(result.after, 2, name).doubt) << name;
    }
}

TEST(Identify, LearnsTheWordsForObjectsFromTheProgramsOwnLines) {
    const auto name = [](const reference::ItemId& id) {
        return id.subject == reference::Subject::sphere ? "blork" : "zwick";
    };
    const auto line = [&](const Program& program, const reference::ItemId& id) {
        return fmt::format("{} {} ==> {}\n", name(id), id.name, list(program, id));
    };
    for (const bool is_right : {true, false}) {
        const auto verdict = [&](const Program& program) {
            const bool sphere = program.first_object() == reference::FirstObject(reference::Subject::sphere);
            return std::string(sphere == is_right ? "blork" : "zwick") + " !";
        };
        const auto result = student_off_axis().run(Printed{line, verdict});
        EXPECT_EQ(item(result.after, 10, "verdict").verdict, is_right ? ItemVerdict::right : ItemVerdict::wrong);
    }
}

TEST(Identify, SaysWhyNothingIsSettled) {
    const std::string constant = Printed{arrow}(student_off_axis().program());
    EXPECT_EQ(student_off_axis().run([&](const Program&) { return constant; }).report.unsettled,
              "the program prints the same numbers on every scene");
    int run = 0;
    const auto other_lines = [&](const Program& program) {
        return ++run == 1 ? Printed{arrow}(program) : std::string("Question 6\nnothing 1 here\n");
    };
    EXPECT_EQ(student_off_axis().run(other_lines).report.unsettled, "its output has different lines on other scenes");
}

TEST(Identify, KeepsTheDoubtAboutATransposeThatIsNotUsed) {
    const auto matrix = [](const Program& program, const reference::ItemId& id) {
        if (id != student::rhs) return std::string();
        std::string text = "gleb\n";
        for (const float x : *program.values().at(student::matrix)) text += fmt::format("{:f}\n", x);
        return text;  // column by column, one number a line
    };
    const auto result = student_off_axis().run(Printed{matrix});
    EXPECT_NE(item(result.after, 8, "matrix").verdict, ItemVerdict::right);
    EXPECT_TRUE(item(result.after, 8, "matrix").doubt);
}

}  // namespace
}  // namespace harness::experiment
