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

/// A submission whose experiment has one of each.
Graded with_an_experiment() {
    Graded one = graded("zoe", output_with_a_mistake());
    ExperimentReport& experiment = one.findings.experiment.emplace();
    experiment.places = {*read_lines("2-5")};
    experiment.doubts = {{6, "d", {Doubt::Why::right_elsewhere, 7}, {}}};
    experiment.mistakes = {{6, "t", "far root", "The nearer one."}};
    return one;
}

/// Each changes one thing that no report, or not every report, shows.
using Change = void (*)(Graded&);
const Change changes_of_a_field[] = {
    [](Graded& one) { one.execution.our_fault = !one.execution.our_fault; },
    [](Graded& one) { one.execution.build.tried = !one.execution.build.tried; },
    [](Graded& one) { one.execution.build.compiled = !one.execution.build.compiled; },
    [](Graded& one) { one.execution.build.reached_limit = true; },
    [](Graded& one) { one.execution.run.error = 8; },
    [](Graded& one) { one.execution.run.errors_truncated = true; },
    [](Graded& one) { one.submission.name = "Doe, Zoe"; },
    [](Graded& one) { one.submission.problem = "unreadable \xff"; },
    [](Graded& one) {
        one.submission.notes = {"older: a.cpp", ""};
    },
    [](Graded& one) { one.submission.lms = LmsName{Lms::moodle, "Zoe", "17", "4", "a b.cpp", {}, false}; },
    [](Graded& one) { one.submission.lms.emplace().late = false; },
    [](Graded& one) { one.submission.lms.emplace().late = true; },
    [](Graded& one) { one.submission.lms.emplace().handed_in = "2026-11-05 23:59"; },
    [](Graded& one) {
        one.submission.lms.emplace().submitters = {{"Zoe", "s1", "z@x"}, {"Max", "", ""}};
    },
    [](Graded& one) { one.score.questions[5].items[4].advice = "The nearer one."; },
    [](Graded& one) { one.score.questions[5].items[4].experiment = "Line 9 was read as t."; },
    [](Graded& one) { one.score.questions[5].items[4].reread = "Read from line 12, as Ada says: so"; },
    [](Graded& one) { one.score.questions[5].items[4].by_order = true; },
    [](Graded& one) { one.score.questions[2].items[0].by_columns = !one.score.questions[2].items[0].by_columns; },
    [](Graded& one) { one.score.questions[2].items[0].last_line += 3; },
    [](Graded& one) { one.findings.experiment.reset(); },
    [](Graded& one) { one.findings.experiment->unsettled = "the program ended differently"; },
    [](Graded& one) { one.findings.experiment->places[0].question = 6; },
    [](Graded& one) { one.findings.experiment->places[0].item = "hit"; },
    [](Graded& one) { one.findings.experiment->places[0] = *read_lines("12:2-4,13:-2"); },
    [](Graded& one) { one.findings.experiment->places[0].order = MatrixOrder::columns; },
    [](Graded& one) { one.findings.experiment->places[0].note = "Lines 12-13 were read as hit."; },
    [](Graded& one) { one.findings.experiment->places[0].by_experiment = true; },
    [](Graded& one) { one.findings.experiment->places[0].as_read = true; },
    [](Graded& one) { one.findings.experiment->places[0].first_object = reference::FirstObject::tie; },
    [](Graded& one) { one.findings.experiment->places[0].first_object = reference::FirstObject::no_hit; },
    [](Graded& one) {
        one.findings.experiment->places[0].first_object = reference::FirstObject(reference::Subject::cylinder);
    },
    [](Graded& one) { one.findings.experiment->doubts[0].question = 7; },
    [](Graded& one) { one.findings.experiment->doubts[0].item = "c"; },
    [](Graded& one) {
        one.findings.experiment->doubts[0].doubt = {Doubt::Why::words_left, 8};
    },
    [](Graded& one) {
        one.findings.experiment->doubts[0].layout_doubt = Doubt{Doubt::Why::words_left, 8};
    },
    [](Graded& one) {
        one.findings.experiment->mistakes[0] = {8, "u", "", ""};
    },
};

TEST(GradedRecord, RestoresEveryField) {
    const Graded plain = with_an_experiment();
    for (std::size_t i = 0; i < std::size(changes_of_a_field); ++i) {
        Graded changed = plain;
        changes_of_a_field[i](changed);
        EXPECT_NE(to_record(changed), to_record(plain)) << "change " << i;
        EXPECT_EQ(to_record(again(changed)), to_record(changed)) << "change " << i;
    }
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
