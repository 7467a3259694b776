#include "harness/grade/reread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/grade/grade_submission.h"
#include "harness/text/lines.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"

namespace harness {
namespace {

using testing::Contains;
using testing::Not;

const Marking& edge_marking() {
    static const Marking edge = make_marking(student::edge_scene().assignment);
    return edge;
}

TEST(Layout, IsTheSameForOtherNumbersAndOtherBlanks) {
    EXPECT_EQ(layout_of("t = 1.5\nhit: (1, 2, 3)\n"), layout_of("t =   -2.5e-3\nhit: (0,  nan, -inf)\n"));
    EXPECT_EQ(layout_of("t = 1"), layout_of("t = 12 \n"));
}

TEST(Layout, IsTheSameForOtherNumbersThatAreGluedToLetters) {
    EXPECT_EQ(layout_of("t1.5\n"), layout_of("t2.25e-7\n"));
    EXPECT_EQ(layout_of("x1.5y-2e-3z3m\n"), layout_of("x1y0.3z-30m\n"));
    EXPECT_EQ(layout_of("at 0x7ffe12ab, 5.\n"), layout_of("at 0x55d0, 5.25.\n"));
    EXPECT_EQ(layout_of("P.x .5 -.5\n"), layout_of("P.x 1 2\n"));
}

TEST(Layout, IgnoresEscapesAndLineEnds) {
    EXPECT_EQ(layout_of("t = -1\r\n"), layout_of("t = 1\n"));
    EXPECT_EQ(layout_of("t = \xE2\x88\x92"
                        "1\n"),
              layout_of("t = 1\n"))
        << "a minus sign beyond ASCII";
    EXPECT_EQ(layout_of("\x1b[31mt\x1b[0m = 1\n"), layout_of("t = 1\n"));
    EXPECT_NE(layout_of("t = 1\rs = 2\n"), layout_of("t = 1 s = 2\n")) << "a return begins a line";
}

TEST(Layout, DiffersWhereWordsOrLinesDo) {
    EXPECT_NE(layout_of("t = 1.5\n"), layout_of("s = 1.5\n"));
    EXPECT_NE(layout_of("t = 1.5\n"), layout_of("t = none\n"));
    EXPECT_NE(layout_of("t = 1.5\n"), layout_of("\nt = 1.5\n"));
    EXPECT_NE(layout_of("1 2\n"), layout_of("1\n2\n"));
    EXPECT_NE(layout_of("t = nano\n"), layout_of("t = 1\n"));
    EXPECT_NE(layout_of("info\n"), layout_of("1o\n"));
}

/// A right printout in which t stands under a name that nobody knows, marked without and with a reread.
Graded with_unknown_label() {
    Graded graded;
    graded.execution.printout = print(student::Program(edge_marking().assignment, {}));
    const std::size_t at = graded.execution.printout.find("\nt");
    graded.execution.printout.insert(at + 1, "old ");
    mark_again(graded, edge_marking());
    return graded;
}

int line_of_old(const Graded& graded) {
    const std::string before = graded.execution.printout.substr(0, graded.execution.printout.find("old "));
    return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
}

const ItemScore& t_of(const Graded& graded) {
    return graded.score.questions.at(5).items.at(4);
}

TEST(MarkAgain, ReadsWhereTheCorrectionSays) {
    Graded graded = with_unknown_label();
    ASSERT_EQ(t_of(graded).spec.name, "t");
    ASSERT_NE(t_of(graded).verdict, ItemVerdict::right);
    const double before = graded.score.points;
    graded.submission.rereads = {
        {6, "t", std::to_string(line_of_old(graded)), layout_of(graded.execution.printout), "it is t", "Ada", ""}};
    graded.score.variants = ScenesScore{3, 5};
    mark_again(graded, edge_marking());
    EXPECT_EQ(t_of(graded).verdict, ItemVerdict::right);
    EXPECT_TRUE(counts(graded, graded.submission.rereads.front()));
    EXPECT_GT(graded.score.points, before + 3);
    EXPECT_EQ(graded.score.max_points, 105) << "the points for other scenes stay";
    EXPECT_TRUE(std::none_of(graded.findings.flags.begin(), graded.findings.flags.end(),
                             [](const Flag& flag) { return flag.evidence.find("6.t") != std::string::npos; }));
}

TEST(MarkAgain, KeepsWhatOtherScenesShowedBesideAReread) {
    Graded graded = with_unknown_label();
    const std::string line = std::to_string(line_of_old(graded));
    ItemPlace place = *read_lines(line + ":1");
    place.question = 6;
    place.item = "t";
    place.note = "Line " + line + " was read as t because it changes as t does on 2 other scenes.";
    place.by_experiment = true;
    graded.findings.experiment.emplace().places = {place};
    graded.submission.rereads = {{6, "a", "", layout_of(graded.execution.printout), "a debug line", "Ada", ""}};
    mark_again(graded, edge_marking());
    EXPECT_EQ(t_of(graded).verdict, ItemVerdict::right);
    EXPECT_EQ(t_of(graded).experiment, place.note);
    EXPECT_EQ(t_of(graded).reread, "");
    graded.submission.rereads.push_back({6, "t", "", layout_of(graded.execution.printout), "so", "Ada", ""});
    mark_again(graded, edge_marking());
    EXPECT_EQ(t_of(graded).verdict, ItemVerdict::missing) << "a person counts more";
    EXPECT_EQ(t_of(graded).experiment, "");
}

TEST(MarkAgain, DoesNotCountARereadForAnotherLayout) {
    Graded graded = with_unknown_label();
    graded.submission.rereads = {
        {6, "t", std::to_string(line_of_old(graded)), layout_of("something else"), "it is t", "Ada", ""}};
    mark_again(graded, edge_marking());
    EXPECT_NE(t_of(graded).verdict, ItemVerdict::right);
    EXPECT_FALSE(counts(graded, graded.submission.rereads.front()));
}

TEST(MarkAgain, MarksAnItemThatWasNotPrintedAsMissing) {
    Graded graded;
    graded.execution.printout = print(student::Program(edge_marking().assignment, {}));
    graded.submission.rereads = {{6, "t", "", layout_of(graded.execution.printout), "a debug line", "Ada", ""}};
    mark_again(graded, edge_marking());
    EXPECT_EQ(t_of(graded).verdict, ItemVerdict::missing);
    EXPECT_EQ(t_of(graded).reread, "Not printed, as Ada says: a debug line");
    EXPECT_FALSE(t_of(graded).doubt);
}

/// What grading gives a submission whose program prints this.
Graded graded_with(const Submission& submission, const std::string& output) {
    static const Runner runner = make_runner(std::make_unique<const Sandbox>(Tier::unsafe), {}, {});
    Executions executions;
    executions.runs.resize(1);
    executions.runs.front().run.ended = Ended::exited;
    executions.runs.front().run.output = output;
    Timeline timeline;
    return mark(submission, executions, edge_marking(), runner, nullptr, timeline);
}

std::vector<std::pair<std::string, std::string>> flags_of(const Graded& graded) {
    std::vector<std::pair<std::string, std::string>> flags;
    for (const Flag& flag : graded.findings.flags) flags.emplace_back(flag.kind, flag.evidence);
    return flags;
}

/// Grades the submission, gives it the rereads, and compares it with the same graded again. Returns it.
Graded reread_is_regraded(const std::string& source, const std::string& output, const std::vector<Reread>& rereads) {
    Submission submission;
    submission.source = source;
    Graded graded = graded_with(submission, output);
    graded.findings.flags.push_back({"late_without_date", "Handed in late."});
    submission.rereads = graded.submission.rereads = rereads;
    mark_again(graded, edge_marking());
    Graded again = graded_with(submission, output);
    again.findings.flags.push_back({"late_without_date", "Handed in late."});
    EXPECT_EQ(graded.score.points, again.score.points);
    EXPECT_EQ(flags_of(graded), flags_of(again));
    EXPECT_EQ(graded.findings.own_scene.has_value(), again.findings.own_scene.has_value());
    return graded;
}

/// Question 6 of a program whose sphere is 0.25 higher, as its source says.
struct HigherSphere {
    HigherSphere() {
        reference::Assignment other = edge_marking().assignment;
        auto& center = other.scene.spheres.front().center;
        center.y = reference::Decimal::parse(std::to_string(center.y.to_double() + 0.25)).value();
        source = "glm::vec3 center(" + center.x.text() + ", " + center.y.text() + ", " + center.z.text() + ");";
        const std::string all = print(student::Program(other, {}));
        const std::size_t begin = all.find("Question 6");
        output = all.substr(begin, all.find("Question 7") - begin);
    }
    std::string source, output;
};

TEST(MarkAgain, FindsTheSceneOfASourceAsGradingDoes) {
    const HigherSphere higher;
    std::string output;
    std::vector<Reread> rereads;
    int line = 0;
    for (const std::string_view text : lines_of(higher.output)) {
        ++line;
        const std::string_view name = text.substr(0, text.find_first_of(" :="));
        const bool is_asked = name == "b" || name == "t";
        if (is_asked) {
            output += "old ";
            rereads.push_back({6, std::string(name), std::to_string(line), "", "it is", "Ada", ""});
        }
        if (is_asked || text.find_first_of("0123456789") == 0 || text.starts_with("Q")) output += std::string(text);
        output += '\n';
    }
    ASSERT_EQ(rereads.size(), 2U) << higher.output;
    for (Reread& each : rereads) each.layout = layout_of(output);
    EXPECT_TRUE(reread_is_regraded(higher.source, output, rereads).findings.own_scene) << output;
}

TEST(MarkAgain, StaysWithTheSceneOfASourceThatIsNotKept) {
    const HigherSphere higher;
    Submission submission;
    submission.source = higher.source;
    const Graded before = graded_with(submission, higher.output);
    Graded graded = before;
    graded.submission.source.clear();
    mark_again(graded, edge_marking());
    EXPECT_EQ(graded.score.points, before.score.points);
    EXPECT_EQ(flags_of(graded), flags_of(before));
    EXPECT_TRUE(graded.findings.own_scene);
}

TEST(MarkAgain, ForgetsASceneThatNoLongerExplainsAnything) {
    const HigherSphere higher;
    Submission submission;
    submission.source = higher.source;
    ASSERT_TRUE(graded_with(submission, higher.output).findings.own_scene);
    std::vector<Reread> rereads;
    for (const reference::ItemSpec& item : asked_items(graded_with({}, higher.output).score))
        rereads.push_back({6, std::string(item.name), "", layout_of(higher.output), "a debug line", "Ada", ""});
    EXPECT_FALSE(reread_is_regraded(higher.source, higher.output, rereads).findings.own_scene);
}

TEST(MarkAgain, CountsAnswersInTheSourceAsGradingDoes) {
    const std::string output = print(student::Program(edge_marking().assignment, {}));
    const std::string source = "int main() { puts(R\"(" + output + ")\"); }";
    std::vector<Reread> rereads;
    const Graded before = graded_with({}, output);
    for (const QuestionScore& question : before.score.questions) {
        for (const ItemScore& item : question.items)
            rereads.push_back({question.number, std::string(item.spec.name), "", layout_of(output), "x", "Ada", ""});
    }
    EXPECT_THAT(flags_of(reread_is_regraded(source, output, {})), Contains(testing::Pair("hard_coded", testing::_)));
    EXPECT_THAT(flags_of(reread_is_regraded(source, output, rereads)),
                Not(Contains(testing::Pair("hard_coded", testing::_))));
}

}  // namespace
}  // namespace harness
