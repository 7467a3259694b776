// The reports of a measurement and of an assignment: what they say, and that independent programs can read them.
#include "harness/report/accuracy/report.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "harness/report/accuracy/summary.h"
#include "tests/given/report/told_by.h"
#include "tests/given/sample_measurement.h"

namespace {

using namespace harness::report;
using namespace reference::accuracy;
using nlohmann::json;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// An item that float decides differently, one with errors, and a sign that float decides wrongly.
AssignmentAccuracy unlucky() {
    AssignmentAccuracy assignment;
    assignment.assignment = "rays";
    assignment.title = "<i>Rays</i> & more\x1b[0m";
    assignment.items = {{{8, "hit", reference::Shape::vector, "P_t", reference::item::triangle::hit},
                         0,
                         0,
                         {{"float", true, 0, 0, 0}, {"double", false, 0, 0, 0}}},
                        {{6, "t", reference::Shape::scalar, "t", reference::item::sphere::t},
                         0x1p-24,
                         4.9e-6,
                         {{"float", false, 2.4e-8, 0.41, 0.005}, {"double", false, 1e-16, 1.6e-9, 2e-11}}}};
    assignment.decisions = {
        {"triangle: u", "on which side of the edge from A to C the ray passes", -1, -2.5e-9, false, true, {"float"}},
        {"triangle: t", "whether the triangle lies ahead of the ray's start", 0, 0, false, false, {}},
        {"sphere: d", "whether the ray's line meets the sphere", 1, 2, true, true, {}}};
    return assignment;
}

TEST(AccuracyJson, HasEveryFigure) {
    const json figures = json::parse(accuracy_json(samples::ladder()));
    EXPECT_EQ(figures.at("rows").size(), samples::ladder().rows.size());
    EXPECT_EQ(figures.at("key_ms").at("certified"), json({30, 31, 35}));
    EXPECT_EQ(figures.at("load"), 2.34);
    const json first = json::parse(accuracy_json(samples::two_methods())).at("rows").at(0);
    EXPECT_EQ(first, json::parse(R"({"primitive": "sphere", "kernel": "certified", "scalar": "double",
        "source": "a paper", "distribution": "grazing", "hard": true, "rays": 1000, "ns_per_ray": 10.5, "ns_low": 10.25,
        "ns_high": 11, "wrong": 0, "wrong_per_million": 0, "wrong_low": 0, "wrong_high": 3827, "max_ulp": 0.5,
        "mean_ulp": 0.125, "pareto": true, "certain": true})"));
}

TEST(AccuracyPage, BeginsWithThePlotsAndFoldsTheRest) {
    const std::string page = accuracy_html({samples::ladder(), unlucky()});
    const std::size_t plots = page.find("<svg"), first_fold = page.find("<details");
    ASSERT_NE(plots, std::string::npos);
    EXPECT_EQ(page.find("</h1>\n<svg"), plots - 6);
    EXPECT_LT(plots, first_fold);
    EXPECT_GT(page.find("<table"), first_fold);
    EXPECT_GT(page.find("<pre"), first_fold);
    EXPECT_LT(page.find("The machine was busy"), first_fold);
    EXPECT_THAT(page, HasSubstr("Is float enough? No, but double is."));
    // Mean of the hard sets, then each set.
    EXPECT_THAT(page,
                ContainsRegex("<th scope=\"row\">half-b branch-free double</th><td>5.10</td><td>[^<]*</td><td>469</td>"
                              "<td>80[0-9]</td><td>13[0-9]</td>"));
}

TEST(AccuracyReports, LeaveOutWhatWasNotMeasured) {
    EXPECT_THAT(accuracy_html({samples::two_methods(), {}}), Not(HasSubstr("id=\"assignment\"")));
    const json row = json::parse(accuracy_json(samples::two_methods())).at("rows").at(1);
    EXPECT_TRUE(row.at("max_ulp").is_null() && row.at("mean_ulp").is_null());
}

TEST(AccuracyReports, SurviveHostileNames) {
    const AccuracyFindings findings{samples::hostile(), unlucky()};
    EXPECT_EQ(python("d = json.load(open(sys.argv[1], encoding='utf-8'))\n"
                     "print(d['rows'][0]['kernel'])\nprint(ascii(d['processor']))\n",
                     accuracy_json(*findings.measured)),
              "<script>alert('k')</script> & \"kernel\"\n'a\\\\x01z\\\\xff]]>'\n");
    EXPECT_THAT(accuracy_text(findings), Not(HasSubstr("\x1b")));
    const std::string page = accuracy_html(findings);
    for (const char* tag : {"<script", "src=", "<link", "@import", "url(", "<b>", "<i>", "\x1b"})
        EXPECT_THAT(page, Not(HasSubstr(tag)));
    EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&#39;k&#39;)&lt;/script&gt; &amp; &quot;kernel&quot;"));
}

TEST(AccuracyPage, IsWellFormedAndHasUniqueIds) {
    for (const auto& measured : {samples::two_methods(), samples::ladder(), samples::hostile()}) {
        const std::string page = accuracy_html({measured, unlucky()});
        EXPECT_EQ(told_by("xmllint --noout \"$1\"", page), "");
        EXPECT_EQ(told_by("grep -o ' id=\"[^\"]*\"' \"$1\" | sort | uniq -d", page), "");
    }
}

TEST(AccuracyText, FitsATerminal) {
    const std::string text = accuracy_text({samples::ladder(), {}});
    std::size_t longest = 0;
    for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
        std::size_t characters = 0;
        for (std::size_t i = at; text[i] != '\n'; ++i)
            characters += (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
        longest = std::max(longest, characters);
    }
    EXPECT_LE(longest, 120U);
}

TEST(AccuracyText, ListsTheFrontierFromTheFastestToTheExact) {
    const std::string text = accuracy_text({samples::ladder(), {}});
    EXPECT_THAT(text,
                ContainsRegex(
                    "sphere +half-b branch-free double +5\\.10 \\(4\\.95–5\\.30\\) +1\\.00 \\(0\\.93–1\\.07\\) +469 "));
    EXPECT_THAT(text,
                ContainsRegex("sphere +certified double +10\\.4 \\(10\\.1–10\\.8\\) +2\\.04 \\(1\\.90–2\\.19\\) +0 "));
    EXPECT_THAT(text, HasSubstr("decide exactly, which takes 2.04 (1.90–2.19) times as long as"));
    EXPECT_THAT(text, HasSubstr("31.0 ms (30.0–35.0) certified"));
    EXPECT_THAT(text, HasSubstr("The machine was busy (load 2.3)"));
    EXPECT_THAT(text, Not(HasSubstr("Haines")));
    EXPECT_THAT(accuracy_text({samples::two_methods(), {}}), Not(HasSubstr("busy")));
}

/// However many methods are on the frontier.
TEST(AccuracyText, HasAtMost25Lines) {
    auto measured = samples::ladder();
    std::map<std::string, std::size_t> numbers;  // each method is slower and less often wrong than those before it
    for (auto& row : measured.rows) {
        const std::string name = name_of(row.primitive) + row.kernel + row.scalar;
        const std::size_t number = numbers.emplace(name, numbers.size()).first->second;
        row.ns_per_ray = static_cast<double>(1 + number);
        row.wrong = row.hard ? 50 - number : 0;
    }
    for (const auto& each : {measured, samples::ladder()}) {
        const std::string text = accuracy_text({each, {}});
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 25);
    }
    const auto rows = frontier(summarize(measured).front());
    EXPECT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows.front().ns_per_ray, 1);
}

TEST(AccuracyText, SumsUpTheHardDistributions) {
    auto measured = samples::two_methods();
    auto benign = measured.rows[1];
    benign.distribution = "benign";
    benign.hard = false;
    benign.ns_per_ray = 4;
    benign.wrong = 500;  // not a hard ray's
    auto sliver = measured.rows[1];
    sliver.distribution = "sliver";
    sliver.wrong = 2;
    measured.rows = {benign, measured.rows[1], sliver};
    // 14 of 2000.
    EXPECT_THAT(accuracy_text({measured, {}}), ContainsRegex("naive float +4\\.00 .* 7,000 "));
}

TEST(AssignmentText, SaysFirstWhetherFloatIsEnough) {
    EXPECT_THAT(assignment_text(unlucky()), HasSubstr("\n\nIs float enough? No, but double is.\n"));
    AssignmentAccuracy lucky = unlucky();
    lucky.items.erase(lucky.items.begin());
    lucky.decisions.erase(lucky.decisions.begin());
    EXPECT_THAT(assignment_text(lucky), HasSubstr("Is float enough? Yes"));
    lucky.items.front().errors[1].of_allowance = 2;
    EXPECT_THAT(assignment_text(lucky), HasSubstr("Is float enough? Yes"));
    lucky.items.front().errors[0].of_allowance = 2;
    EXPECT_THAT(assignment_text(lucky), HasSubstr("Is float enough? No, and double is not enough either."));
}

TEST(AssignmentText, IsHalfAPage) {
    AssignmentAccuracy long_one = unlucky();
    long_one.items.insert(long_one.items.end(), 30, long_one.items.back());
    const std::string text = assignment_text(long_one);
    EXPECT_THAT(text, HasSubstr("26 other answers"));
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 25);
}

}  // namespace
