#include "harness/gradebook/record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "harness/report/data/grades_csv.h"
#include "harness/report/data/grades_json.h"
#include "harness/report/text/class_table.h"
#include "harness/report/text/feedback.h"
#include "tests/given/report/graded_samples.h"

namespace harness {
namespace {

using namespace report_samples;
using namespace std::chrono_literals;
using testing::ElementsAre;

Graded again(const Graded& graded) {
    auto restored = from_record(to_record(graded));
    EXPECT_TRUE(restored.has_value());
    return restored ? *restored : Graded{};
}

/// One submission of each kind, with every field that a submission may have.
std::vector<Graded> a_class() {
    Graded late = graded("late", output_with_a_mistake());
    late.submission.lms = read_canvas_name("łzoe_LATE_17_4_ray_cast.cpp");
    late.late_share = 0.1;
    late.score.questions.at(5).items.at(4).reread = "Read from line 12, as Ada says: \xff";
    late.score.questions.at(5).items.at(3).experiment =
        "Line 11 was read as d because it changes as d does on 2 other scenes.";
    late.score.questions.at(5).items.at(2).by_order = true;
    late.score.questions.at(5).items.at(1).doubt = Doubt{Doubt::Why::numbers_left, 3};
    late.findings.experiment = ExperimentReport{{}, {}, {}, "the program prints the same numbers on every scene"};
    late.findings.own_scene = OwnScene{"[camera]\neye = [0, 0, 5]\n", "Your source sets eye = (0, 0, 5)"};
    late.findings.flags = {{"nondeterministic", "run 1 printed \x1b 2"}};
    late.execution.sanitizer = {"line 8: heap-buffer-overflow", "line 9: \xff"};
    late.findings.variants = VariantsReport{VariantsVerdict::does_not_move,
                                            {"C"},
                                            {{"scene 1", "eye = (3, -2, 5)", "eye = (0, 0, 4)", true, {}},
                                             {"scene 2", "radius = 3", "radius = 2", false, {}}},
                                            4,
                                            {{8, "t", 1, "0.5\x1b", "", "far root"}},
                                            {{6, "t", 0, "3.41", "3.41", ""}},
                                            {{"scene 3", "radius = 9", "it does not compile"}, {"", "", "none"}},
                                            7};
    late.execution.build.wall = 1234ms;
    late.execution.run.cpu = 7ms;
    late.execution.run.wall = 9ms;
    late.execution.run.peak_memory_bytes = std::uint64_t{5} << 40;
    late.execution.run.exit_code = 3;
    Graded crashed = graded("crashed", "Question 6:\nt: nan\nd: inf\n");
    crashed.execution.outcome = Outcome::crashed;
    crashed.execution.tier = Tier::unsafe;
    crashed.execution.run.ended = Ended::signalled;
    crashed.execution.run.signal = 11;
    crashed.score.follow_cap = 12.5;
    Graded stopped = graded("stopped", "");
    stopped.execution.outcome = Outcome::timed_out;
    stopped.execution.run.ended = Ended::cpu_limit;
    return {late, crashed, stopped, hostile(), not_graded("none")};
}

TEST(GradedRecord, GivesTheSameReportsByteForByte) {
    const std::vector<Graded> fresh = a_class();
    std::vector<Graded> restored;
    for (const Graded& one : fresh) restored.push_back(again(one));
    EXPECT_EQ(report::grades_json(restored, marking(), Tier::bwrap),
              report::grades_json(fresh, marking(), Tier::bwrap));
    EXPECT_EQ(report::grades_csv(restored), report::grades_csv(fresh));
    EXPECT_EQ(report::class_table(restored), report::class_table(fresh));
    EXPECT_EQ(report::needs_a_person(restored, ""), report::needs_a_person(fresh, ""));
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        EXPECT_EQ(report::feedback_markdown(restored[i], marking()), report::feedback_markdown(fresh[i], marking()));
        EXPECT_EQ(report::check_text(restored[i]), report::check_text(fresh[i]));
    }
}

TEST(GradedRecord, IsRefusedIfANumberDoesNotFitItsField) {
    const auto with_exit_code = [](const nlohmann::json& exit_code) {
        auto record = nlohmann::json::from_cbor(to_record(graded("zoe", "")));
        record["run"]["exit_code"] = exit_code;
        return from_record(nlohmann::json::to_cbor(record));
    };
    EXPECT_TRUE(with_exit_code(3));
    EXPECT_FALSE(with_exit_code(1e300));
    EXPECT_FALSE(with_exit_code(std::int64_t{1} << 40));
    EXPECT_FALSE(with_exit_code(2.5));
}

TEST(GradedRecord, RestoresTheLastLineOfAnAnswer) {
    Graded one = graded("zoe", "Question 3:\n1 0 0 0\n0 1 0 0\n0 0 1 4\n0 0 0 1\n\nQuestion 6:\nt: 3\n");
    const Graded restored = again(one);
    EXPECT_EQ(restored.score.questions[2].items[0].line, 2);
    EXPECT_EQ(restored.score.questions[2].items[0].last_line, 5);
    EXPECT_EQ(restored.score.questions[5].items[4].last_line, 8) << "an answer of one line";
    one.score.questions[2].items[0].reread = "Read from lines 2-5, as Ada says: so";
    EXPECT_EQ(again(one).score.questions[2].items[0].last_line, 5);
    EXPECT_FALSE(again(one).score.questions[2].items[0].by_columns);
    one.score.questions[2].items[0].by_columns = true;
    EXPECT_TRUE(again(one).score.questions[2].items[0].by_columns);
    EXPECT_EQ(again(one).score.questions[2].items[0].reread, "Read from lines 2-5, as Ada says: so");
}

TEST(GradedRecord, RestoresWhatAnExperimentShowed) {
    Graded one = graded("zoe", output_with_a_mistake());
    EXPECT_FALSE(again(one).findings.experiment);
    one.findings.experiment.emplace();
    EXPECT_TRUE(again(one).findings.experiment) << "one that showed nothing";
    ItemPlace by_numbers = *read_lines("12:2-4,13:-2");
    by_numbers.question = 6;
    by_numbers.item = "hit";
    by_numbers.note = "Lines 12-13 were read as hit because they change as hit does on 2 other scenes.";
    by_numbers.by_experiment = true;
    ItemPlace by_lines = *read_lines("2-5");
    by_lines.question = 3;
    by_lines.item = "M_VCS_to_WCS";
    by_lines.order = MatrixOrder::columns;
    ItemPlace as_read;
    as_read.item = "t";
    as_read.as_read = true;
    one.findings.experiment->places = {by_numbers, by_lines, as_read};
    for (const auto& first : {reference::FirstObject::tie, reference::FirstObject::no_hit,
                              reference::FirstObject(reference::Subject::cylinder)}) {
        one.findings.experiment->places.push_back(*read_lines("30"));
        one.findings.experiment->places.back().first_object = first;
    }
    one.findings.experiment->doubts = {{6, "d", {Doubt::Why::right_elsewhere, 7}, Doubt{Doubt::Why::words_left, 8}}};
    one.findings.experiment->mistakes = {{6, "t", "far root", "The nearer one."}, {8, "u", "", ""}};
    one.findings.experiment->unsettled = "the program ended differently on other scenes";
    const Graded restored = again(one);
    ASSERT_TRUE(restored.findings.experiment);
    const ExperimentReport &is = *restored.findings.experiment, &was = *one.findings.experiment;
    ASSERT_EQ(is.places.size(), was.places.size());
    for (std::size_t i = 0; i < was.places.size(); ++i) {
        EXPECT_EQ(is.places[i].question, was.places[i].question) << i;
        EXPECT_EQ(is.places[i].item, was.places[i].item) << i;
        EXPECT_EQ(is.places[i].first_line, was.places[i].first_line) << i;
        EXPECT_EQ(is.places[i].last_line, was.places[i].last_line) << i;
        EXPECT_EQ(is.places[i].numbers, was.places[i].numbers) << i;
        EXPECT_EQ(is.places[i].order, was.places[i].order) << i;
        EXPECT_EQ(is.places[i].first_object, was.places[i].first_object) << i;
        EXPECT_EQ(is.places[i].note, was.places[i].note) << i;
        EXPECT_EQ(is.places[i].by_experiment, was.places[i].by_experiment) << i;
        EXPECT_EQ(is.places[i].as_read, was.places[i].as_read) << i;
    }
    ASSERT_EQ(is.doubts.size(), 1U);
    EXPECT_EQ(is.doubts[0].question, 6);
    EXPECT_EQ(is.doubts[0].item, "d");
    EXPECT_EQ(is.doubts[0].doubt.why, Doubt::Why::right_elsewhere);
    EXPECT_EQ(is.doubts[0].doubt.line, 7);
    EXPECT_EQ(is.doubts[0].layout_doubt.value().why, Doubt::Why::words_left);
    ASSERT_EQ(is.mistakes.size(), 2U);
    EXPECT_EQ(is.mistakes[0].question, 6);
    EXPECT_EQ(is.mistakes[0].item, "t");
    EXPECT_EQ(is.mistakes[0].diagnosis, "far root");
    EXPECT_EQ(is.mistakes[0].advice, "The nearer one.");
    EXPECT_EQ(is.unsettled, was.unsettled);
}

TEST(GradedRecord, RefusesInvalidPlaces) {
    Graded one = graded("zoe", output_with_a_mistake());
    one.findings.experiment.emplace().places = {*read_lines("30")};
    one.findings.experiment->places.back().first_object = reference::FirstObject::tie;
    for (const char* field : {"lines", "first_object"}) {
        auto record = nlohmann::json::from_cbor(to_record(one));
        record["experiment"]["places"][0][field] = "unheard of";
        EXPECT_FALSE(from_record(nlohmann::json::to_cbor(record))) << field;
    }
}

TEST(GradedRecord, RestoresHowAnItemWasFound) {
    Graded one = graded("zoe", output_with_a_mistake());
    one.score.questions[5].items[4].experiment = "Line 9 was read as t because it changes as t does on 2 other scenes.";
    one.score.questions[5].items[3].by_order = true;
    const Graded restored = again(one);
    EXPECT_EQ(restored.score.questions[5].items[4].experiment, one.score.questions[5].items[4].experiment);
    EXPECT_FALSE(restored.score.questions[5].items[4].by_order);
    EXPECT_EQ(restored.score.questions[5].items[3].experiment, "");
    EXPECT_TRUE(restored.score.questions[5].items[3].by_order);
}

TEST(GradedRecord, RestoresFieldsThatNoReportShows) {
    Graded one = graded("zoe", output_with_a_mistake());
    one.execution.our_fault = true;
    one.submission.name = "Doe, Zoe";
    one.submission.problem = "unreadable \xff";
    one.submission.notes = {"older: a.cpp", ""};
    one.submission.lms = LmsName{Lms::moodle,
                                 "Zoe",
                                 "17",
                                 "4",
                                 "a b.cpp",
                                 {},
                                 false,
                                 "2026-11-05 23:59",
                                 {{"Zoe", "s1", "z@x"}, {"Max", "", ""}}};
    one.execution.build.tried = one.execution.build.compiled = one.execution.build.reached_limit = true;
    one.execution.run.error = 8;
    one.execution.run.errors_truncated = true;
    one.score.questions[5].items[4].advice = "The nearer one.";
    const Graded restored = again(one);
    EXPECT_TRUE(restored.execution.our_fault);
    EXPECT_EQ(restored.submission.name, "Doe, Zoe");
    EXPECT_EQ(restored.submission.problem, "unreadable \xff");
    EXPECT_THAT(restored.submission.notes, ElementsAre("older: a.cpp", ""));
    ASSERT_TRUE(restored.submission.lms);
    EXPECT_EQ(restored.submission.lms->system, Lms::moodle);
    EXPECT_EQ(restored.submission.lms->attachment, "4");
    EXPECT_EQ(restored.submission.lms->file, "a b.cpp");
    EXPECT_FALSE(restored.submission.lms->is_file);
    EXPECT_EQ(restored.submission.lms->late, std::nullopt);
    EXPECT_EQ(restored.submission.lms->handed_in, "2026-11-05 23:59");
    ASSERT_EQ(restored.submission.lms->submitters.size(), 2U);
    EXPECT_EQ(restored.submission.lms->submitters[0].email, "z@x");
    EXPECT_EQ(restored.submission.lms->submitters[1].name, "Max");
    for (const bool late : {false, true}) {
        one.submission.lms.emplace().late = late;
        EXPECT_EQ(again(one).submission.lms->late, late);
    }
    EXPECT_TRUE(restored.execution.build.tried && restored.execution.build.compiled &&
                restored.execution.build.reached_limit);
    EXPECT_EQ(restored.execution.run.error, 8);
    EXPECT_TRUE(restored.execution.run.errors_truncated);
    EXPECT_EQ(restored.score.questions[5].items[4].advice, "The nearer one.");
    EXPECT_EQ(restored.score.questions[5].items[4].spec.label, one.score.questions[5].items[4].spec.label);
}

TEST(GradedRecord, FromAnOlderRaygradeHasItsMissingFieldsEmpty) {
    auto json = nlohmann::json::from_cbor(to_record(a_class().front()));
    ASSERT_EQ(json.at("other_scenes").erase("seed"), 1U);
    ASSERT_EQ(json.at("other_scenes").erase("not_tried"), 1U);
    ASSERT_EQ(json.erase("experiment"), 1U);
    auto& row_of_d = json.at("score").at("questions").at(5).at("items").at(3);
    row_of_d.erase(row_of_d.size() - 1);
    const auto older = from_record(nlohmann::json::to_cbor(json));
    ASSERT_TRUE(older);
    EXPECT_FALSE(older->findings.experiment);
    EXPECT_EQ(older->score.questions.at(5).items.at(3).experiment, "");
    EXPECT_EQ(older->findings.variants->seed, std::nullopt);
    EXPECT_TRUE(older->findings.variants->not_tried.empty());
    EXPECT_EQ(older->findings.variants->runs.size(), 2U);
}

TEST(GradedRecord, KeepsEveryNumberExactly) {
    Graded one = graded("zoe", output_with_a_mistake());
    one.score.points = 100.0 / 3;
    ItemScore& item = one.score.questions[5].items[4];
    for (const double x : {0.0, 1e-300, 0.1, 1.0 / 3, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::denorm_min(), 123456789.125}) {
        item.error = x;
        item.allowance = x;
        const Graded restored = again(one);
        EXPECT_EQ(restored.score.questions[5].items[4].error, x);
        EXPECT_EQ(restored.score.questions[5].items[4].allowance, x);
        EXPECT_EQ(restored.score.points, 100.0 / 3);
    }
    item.error = std::nan("");
    EXPECT_TRUE(std::isnan(*again(one).score.questions[5].items[4].error));
    item.error.reset();
    EXPECT_FALSE(again(one).score.questions[5].items[4].error.has_value());
}

TEST(GradedRecord, HasTheSameBytesForTheSameSubmission) {
    for (const Graded& one : a_class()) EXPECT_EQ(to_record(again(one)), to_record(one));
    Graded other = a_class().front();
    other.score.questions[9].items[0].points += 0.001;
    EXPECT_NE(to_record(other), to_record(a_class().front()));
}

TEST(GradedRecord, RefusesOtherBytes) {
    const std::vector<std::uint8_t> whole = to_record(hostile());
    ASSERT_GT(whole.size(), 1000U);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(from_record({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
    }
    for (const char* path :
         {"/outcome", "/sandbox", "/run/ended", "/score/questions/0/items/0/1", "/score/questions/0/items/0/0"}) {
        auto json = nlohmann::json::from_cbor(whole);
        ASSERT_TRUE(json.contains(nlohmann::json::json_pointer(path))) << path;
        json[nlohmann::json::json_pointer(path)] = "unheard of";
        EXPECT_FALSE(from_record(nlohmann::json::to_cbor(json))) << path;
        json[nlohmann::json::json_pointer(path)] = 7;
        EXPECT_FALSE(from_record(nlohmann::json::to_cbor(json))) << path;
    }
}

}  // namespace
}  // namespace harness
