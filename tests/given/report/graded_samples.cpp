#include "tests/given/report/graded_samples.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "harness/mark/score/mark_transcript.h"
#include "tests/given/student/printout.h"
#include "tests/given/student/scenes.h"

namespace report_samples {

using namespace harness;

const Marking& marking() {
    static const Marking off_axis = [] {
        student::Marking scene = student::off_axis_scene();
        return Marking{std::move(scene.assignment), std::move(scene.key)};
    }();
    return off_axis;
}

std::string output_with_a_mistake() {
    const student::Program program(
        marking().assignment, {},
        student::Program::Mistake{reference::item::sphere::t, [](const student::Program& p, const auto&) {
                                      const float root = std::sqrt(p.scalar(reference::item::sphere::d));
                                      return std::optional(
                                          student::floats((-p.scalar(reference::item::sphere::b) + root) / 2));
                                  }});
    return print(program);
}

Graded graded(const std::string& id, const std::string& output) {
    Graded result;
    result.submission.id = id;
    result.submission.file = id + "/ray_cast.cpp";
    result.submission.source_sha256 = std::string(64, 'a');
    result.execution.outcome = output.empty() ? Outcome::no_output : Outcome::graded;
    result.execution.run.ended = Ended::exited;
    result.score = score(read_transcript(output, 10), marking().key, marking().assignment);
    return result;
}

Graded graded_on_variants(const std::string& id) {
    Graded result = graded(id, output_with_a_mistake());
    result.score.variants = ScenesScore{6, 10};
    result.score.points += 6;
    result.score.max_points += 10;
    return result;
}

Graded hostile() {
    const std::string evil = "`` ``` | <b>&\x1b[31m\xff\xfe\a =cmd()";
    Graded result = graded("=HYPERLINK(\"x\"),|`id`", "Question 6:\nt: " + evil + "\nhit point: `" + evil + "` 1.25\n");
    result.score.questions[5].items[4].printed = evil;
    result.score.questions[5].items[4].verdict = ItemVerdict::wrong;
    result.score.questions[5].items[4].line = 2;
    result.execution.explanation = "=1+1 \"quoted\",\nnext line";
    result.execution.build.diagnostics = "ray_cast.cpp:1: ```` " + evil;
    result.execution.run.errors = evil;
    result.submission.notes = {evil};
    return result;
}

std::string markup(int n) {
    return fmt::format("\"'><b>mark {}</b>&amp;", n);
}

Graded markup_everywhere() {
    Graded result = graded(markup(1), wrong_everywhere());
    result.submission.lms = LmsName{};
    result.submission.lms->student = markup(2);
    result.submission.file = "ray_cast " + markup(3).substr(0, markup(3).find('/')) + ".cpp";
    result.execution.explanation = markup(4);
    ItemScore& item = result.score.questions[5].items[4];
    item.printed = markup(5);
    item.verdict = ItemVerdict::wrong;
    item.diagnosis = markup(6);
    result.execution.build.diagnostics = "ray_cast.cpp:3:5: error: " + markup(7) + "\n";
    result.execution.run.errors = markup(8);
    result.findings.flags = {{markup(9), markup(10)}};
    result.execution.sanitizer = {markup(11)};
    result.submission.notes = {markup(12)};
    result.findings.variants = VariantsReport{};
    VariantsReport& variants = *result.findings.variants;
    variants.verdict = VariantsVerdict::breaks;
    variants.runs.push_back({markup(13), markup(14), "", true, {}});
    variants.not_found = {markup(13)};
    variants.broken.push_back({6, "t", 0, markup(13), markup(14), markup(14)});
    result.findings.hard_scenes =
        HardScenesReport{{}, {{"far", "", "", markup(16), markup(17), {{6, "t", {}, 0, 0, ""}}}}};
    result.review.overrides = {{6, "b", 1, markup(15), markup(18), markup(19)}};
    return result;
}

VariantsReport broken_on_a_variant(const std::string& before, const std::string& after) {
    VariantsReport report;
    report.verdict = VariantsVerdict::breaks;
    report.runs.push_back({"aside", "eye = (1 2 3)", "eye = (0 0 4)", true, {}});
    report.broken.push_back({6, "t", 0, before, after, ""});
    return report;
}

Graded not_graded(const std::string& id) {
    Graded result = graded(id, "");
    result.execution.outcome = Outcome::not_graded;
    result.execution.explanation = "The folder holds two sources; `keep` one.";
    return result;
}

std::vector<Graded> telling_class() {
    Graded ada = graded_on_variants("adalovelace");
    ada.submission.lms = read_canvas_name("adalovelace_LATE_17_4_ray_cast.cpp");
    ada.submission.name = "Lovelace, Ada";
    ada.submission.notes = {"The file was called ray_cast-2.cpp."};
    ada.submission.source = "int main() {\n    double t = 3.41421;\n}\n";
    ada.execution.printout = output_with_a_mistake();
    ada.execution.build.diagnostics = "ray_cast.cpp:2:12: warning: unused variable 't'\n";
    ada.execution.run.errors = "debug\n";
    ada.findings.flags = {{"hard_coded", "6.t: 3.41421 in line 2"},
                          {"nondeterministic", "Question 1: run 1 printed 1"}};
    ada.execution.sanitizer = {"ray_cast.cpp:2:9: runtime error: division by zero"};
    ada.findings.variants = broken_on_a_variant("1.25", "1.5");
    ada.review.overrides = {{8, "", 3, "half copied", "bea", "2026-11-22T09:20:00Z"},
                            {6, "t", 1.5, "the right idea", "bea", "2026-11-22T09:30:00Z"},
                            {8, "", 4, "copied", "bea", "2026-11-22T09:40:00Z"}};
    ada.late_share = 0.1;
    ada.score.follow_cap = 30;
    ada.score.questions[0].items[0].accepted_as = "the grid pixel convention";
    ada.score.questions[9].items[0].spec.part = 'b';

    Graded cem = graded("cem", output_with_a_mistake());
    cem.execution.outcome = Outcome::crashed;
    cem.execution.run.ended = Ended::signalled;
    cem.execution.explanation = "The program crashed (SIGSEGV). It ended after line 2 of its output.";
    cem.execution.printout = "Question 1:\nP\n";
    for (std::size_t question = 6; question < cem.score.questions.size(); ++question) {
        QuestionScore& cut = cem.score.questions[question];
        cut.verdict = ItemVerdict::missing;
        cem.score.points -= cut.points;
        cut.points = 0;
        for (ItemScore& item : cut.items) {
            ItemScore missing;
            missing.spec = item.spec;
            missing.max_points = item.max_points;
            item = missing;
        }
    }

    Graded eve = not_graded("eve");
    eve.review.overrides = {{0, "", 40, "by hand", "bea", "2026-11-22T09:30:00Z"}};
    return {ada, cem, eve};
}

std::vector<std::string> traces_of_key() {
    std::vector<std::string> traces;
    for (const reference::KeyQuestion& question : marking().key.questions) {
        for (const reference::KeyItem& item : question.items) {
            for (const reference::Answer& answer : item.answers) {
                const auto* numbers = std::get_if<reference::Numbers>(&answer.value);
                if (numbers == nullptr) continue;
                for (const double x : *numbers) {
                    const bool telling = std::abs(x * 100 - std::round(x * 100)) > 1e-6;
                    if (telling) traces.push_back(fmt::format("{:.5f}", std::abs(x)).substr(0, 5));
                }
            }
        }
    }
    return traces;
}

std::string wrong_everywhere() {
    std::string output;
    int question = 0;
    for (const reference::ItemSpec& spec : reference::default_items()) {
        if (spec.question != question) output += fmt::format("Question {}:\n", question = spec.question);
        if (spec.shape == reference::Shape::first_object) {
            output += "ray hits nothing\n";
            continue;
        }
        output += fmt::format("{}:", spec.label);
        for (int i = 0; i < reference::component_count(spec.shape); ++i) output += fmt::format(" {}", 70.25 + 11 * i);
        output += "\n";
    }
    return output;
}

}  // namespace report_samples
