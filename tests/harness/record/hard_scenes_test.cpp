#include "harness/record/hard_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "harness/record/hard_scenes_json.h"
#include "harness/record/hard_scenes_sentences.h"

namespace harness {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

HardScenesReport some_report() {
    HardResult lost{"far", "b² is large", "", "radius = 1", "", {}};
    lost.items = {{6, "d", Loss::digits, 2, 4, ""}, {6, "t", Loss::not_a_number, 0, 0, "far root"}};
    lost.advice = "Use double.";
    HardResult left_out{"near", "", "the source was not found to state vup", "", "", {}};
    HardResult kept{"inside", "the far root counts", "", "radius = 7", "", {}};
    return {{"vup"}, {lost, left_out, kept}};
}

TEST(HardScenesReport, IsWrittenAsReadmeDescribes) {
    HardScenesReport report = some_report();
    report.scenes.push_back({"ended", "it", "", "", "The program crashed.", {}});
    EXPECT_EQ(nlohmann::json(hard_scenes_json(report)), nlohmann::json::parse(R"({
        "survived": 1, "tried": 3, "not_found": ["vup"], "scenes": [
        {"name": "far", "asks": "b² is large", "verdict": "breaks", "skipped": null, "changes": "radius = 1",
         "ended": null, "advice": "Use double.", "items": [
            {"question": 6, "item": "d", "loss": "digits", "digits_kept": 2, "digits_printed": 4, "diagnosis": null},
            {"question": 6, "item": "t", "loss": "not_a_number", "digits_kept": null, "digits_printed": null,
             "diagnosis": "far root"}]},
        {"name": "near", "asks": "", "verdict": "skipped", "skipped": "the source was not found to state vup",
         "changes": null, "ended": null, "advice": null, "items": []},
        {"name": "inside", "asks": "the far root counts", "verdict": "survives", "skipped": null,
         "changes": "radius = 7", "ended": null, "advice": null, "items": []},
        {"name": "ended", "asks": "it", "verdict": "breaks", "skipped": null, "changes": null,
         "ended": "The program crashed.", "advice": null, "items": []}]})"));
}

TEST(HardScenesReport, NamesEveryLoss) {
    struct Named {
        Loss loss;
        std::string name, words;
    };
    const std::vector<Named> all = {{Loss::digits, "digits", "fewer right digits than printed"},
                                    {Loss::wrong, "wrong", "wrong"},
                                    {Loss::missing, "missing", "not printed"},
                                    {Loss::not_a_number, "not_a_number", "nan or inf"},
                                    {Loss::hit_missed, "hit_missed", "the ray hits, but the program printed no value"},
                                    {Loss::miss_hit, "miss_hit", "the ray misses, but the program printed a value"},
                                    {Loss::other_first, "other_first", "wrong first object"}};
    for (const auto& [loss, name, words] : all) {
        const HardScenesReport report{{}, {{"far", "", "", "", "", {{6, "t", loss, 0, 0, ""}}}}};
        const auto json = hard_scenes_json(report);
        EXPECT_EQ(json["scenes"][0]["items"][0]["loss"], name);
        EXPECT_EQ(json["scenes"][0]["verdict"], loss == Loss::digits ? "survives" : "breaks") << name;
        EXPECT_EQ(hard_scenes_json(hard_scenes_from_json(json)), json) << name;
        EXPECT_EQ(losses_in_words(report.scenes[0].items), words + ": question 6 (t)");
    }
}

TEST(HardScenesReport, ReadsBackAsItWasWritten) {
    const auto json = hard_scenes_json(some_report());
    EXPECT_EQ(hard_scenes_json(hard_scenes_from_json(json)), json);
    auto older = nlohmann::json(json);
    older["scenes"][0].erase("advice");
    EXPECT_EQ(hard_scenes_from_json(older).scenes[0].advice, "");
    auto broken = nlohmann::json(json);
    broken["scenes"][0]["items"][0]["loss"] = "nothing";
    EXPECT_THROW(hard_scenes_from_json(broken), std::invalid_argument);
}

TEST(HardScenesSentences, NameTheLoss) {
    const auto sentences = hard_scenes_sentences(some_report());
    ASSERT_EQ(sentences.size(), 2U);
    EXPECT_THAT(sentences[0], HasSubstr("1 of 2 hard scenes"));
    EXPECT_THAT(sentences[1], AllOf(HasSubstr("nan or inf: question 6 (t: far root)"), HasSubstr("d: 2 of 4 digits")));
    EXPECT_THAT(
        hard_scenes_text(some_report()),
        HasSubstr("near                                          left out\n    the source was not found to state vup"));
    EXPECT_THAT(hard_scenes_text(some_report()), ContainsRegex("far +breaks +Use double\\.\n"));
    EXPECT_THAT(sentences[1], HasSubstr("Use double."));
}

}  // namespace
}  // namespace harness
