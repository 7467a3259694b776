// Reads the reports with independent programs: JSON and CSV with Python, HTML and SVG with an XML parser.
#include <gmock/gmock.h>

#include "harness/report/accuracy/report.h"
#include "tests/given/report/told_by.h"
#include "tests/given/sample_measurement.h"

namespace {

using harness::report::AccuracyFindings;
using testing::HasSubstr;
using testing::Not;
namespace report = harness::report;

constexpr const char* read_json = "d = json.load(open(sys.argv[1], encoding='utf-8'))\n";
constexpr const char* read_csv = "r = list(csv.DictReader(open(sys.argv[1], encoding='utf-8', newline='')))\n";

TEST(AccuracyJson, ContainsEveryRowWithItsFigures) {
    const std::string json = report::accuracy_json({samples::two_methods(), {}});
    EXPECT_EQ(python(std::string(read_json) +
                         "print(d['seed'], d['rays'], d['repetitions'], d['compiler'], d['flags'], len(d['rows']))\n"
                         "a = d['rows'][0]\n"
                         "print(a['primitive'], a['kernel'], a['scalar'], a['source'], a['distribution'], a['hard'])\n"
                         "print(a['ns_per_ray'], a['ns_low'], a['ns_high'], a['wrong'], a['wrong_high'])\n"
                         "print(a['max_ulp'], a['p99_ulp'], a['mean_ulp'], a['pareto'], a['pareto_error'])\n",
                     json),
              "7 1000 5 g++ 12 -O2 2\n"
              "sphere certified double a paper grazing True\n"
              "10.5 10.25 11.0 0 3827.0\n"
              "0.5 0.25 0.125 True True\n");
}

TEST(AccuracyJson, HasNullForAMissingT) {
    EXPECT_EQ(python(std::string(read_json) +
                         "b = d['rows'][1]\nprint(b['max_ulp'], b['p99_ulp'], b['mean_ulp'], b['wrong_per_million'])\n",
                     report::accuracy_json({samples::two_methods(), {}})),
              "None None None 12000.0\n");
}

TEST(AccuracyJson, SurvivesHostileNames) {
    EXPECT_EQ(python(std::string(read_json) + "print(d['rows'][0]['kernel'])\nprint(ascii(d['processor']))\n",
                     report::accuracy_json({samples::hostile(), {}})),
              "<script>alert('k')</script> & \"kernel\"\n'a\\\\x01z\\\\xff]]>'\n");
}

TEST(AccuracyCsv, ContainsEveryRowWithItsFigures) {
    EXPECT_EQ(python(std::string(read_csv) +
                         "print(len(r), r[0]['kernel'], r[0]['ns_per_ray'], r[0]['mean_ulp'], r[0]['pareto'])\n"
                         "print(r[1]['kernel'], r[1]['wrong'], repr(r[1]['mean_ulp']), r[1]['pareto_error'])\n",
                     report::accuracy_csv(samples::two_methods())),
              "2 certified 10.5 0.125 true\nnaive 12 '' false\n");
}

TEST(AccuracyCsv, SurvivesHostileNames) {
    EXPECT_EQ(
        python(std::string(read_csv) + "print(r[0]['kernel'])\nprint(repr(r[0]['source']))\nprint(r[1]['kernel'])\n",
               report::accuracy_csv(samples::hostile())),
        "<script>alert('k')</script> & \"kernel\"\n"
        "'\\'=HYPERLINK(\"http://x\"), with, commas\\nand a line'\n"
        "'-b - sqrt(d), \"naive\"\n")
        << "what a spreadsheet would compute stands behind an apostrophe";
}

TEST(AccuracyPages, AreWellFormed) {
    for (const auto& measured : {samples::two_methods(), samples::ladder(), samples::hostile()}) {
        EXPECT_EQ(told_by("xmllint --noout \"$1\"", report::accuracy_svg(measured)), "");
        EXPECT_EQ(told_by("xmllint --noout \"$1\"", report::accuracy_html({measured, {}})), "");
    }
}

TEST(AccuracyPages, LoadNothingAndNeedNoScript) {
    for (const std::string& page :
         {report::accuracy_html({samples::hostile(), {}}), report::accuracy_svg(samples::hostile())}) {
        for (const char* tag : {"<script", "src=", "<link", "@import", "url(", "<b>"})
            EXPECT_THAT(page, Not(HasSubstr(tag)));
        EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(&#39;k&#39;)&lt;/script&gt; &amp; &quot;kernel&quot;"));
    }
}

TEST(AccuracyPages, HaveUniqueIds) {
    const std::string page = report::accuracy_html({samples::ladder(), {}});
    EXPECT_EQ(told_by("grep -o ' id=\"[^\"]*\"' \"$1\" | sort | uniq -d", page), "");
}

TEST(AccuracyPages, SayWhatWasMeasuredAndWithWhat) {
    const std::string html = report::accuracy_html({samples::ladder(), {}});
    for (const char* words : {"Seed 1, 131072 rays", "g++ 12.2.0", "-O3 -march=native -ffp-contract=off",
                              "A processor @ 2.60 GHz", "a book, p. 1", "How to read the pictures"})
        EXPECT_THAT(html, HasSubstr(words));
    EXPECT_THAT(report::accuracy_html({samples::two_methods(), {}}), HasSubstr("Processor: not named by the machine"));
}

TEST(AccuracyText, MarksTheFrontierAndLeavesOutMissingValues) {
    const std::string text = report::accuracy_text({samples::two_methods(), {}});
    EXPECT_THAT(text, HasSubstr("Ray and sphere, grazing (hard)"));
    EXPECT_THAT(
        text,
        HasSubstr(
            "* certified double      10.5       10.2–11.0          0         0–3,830      0.12     0.25     0.50\n"
            "* naive float           8.00       7.50–9.50     12,000    6,880–20,900         -        -        -\n"));
}

TEST(AccuracyText, FitsATerminalAndContainsNoControlBytes) {
    const std::string text = report::accuracy_text({samples::ladder(), {}});
    std::size_t longest = 0;
    for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
        std::size_t characters = 0;
        for (std::size_t i = at; text[i] != '\n'; ++i)
            characters += (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
        longest = std::max(longest, characters);
    }
    EXPECT_LE(longest, 120U);
    EXPECT_THAT(report::accuracy_text({samples::hostile(), {}}), Not(HasSubstr("\x1b")));
}

TEST(AccuracyText, SumsUpTheHardDistributionsAndNamesTheWorst) {
    auto measured = samples::two_methods();
    auto benign = measured.rows[1];
    benign.distribution = "benign";
    benign.hard = false;
    benign.ns_per_ray = 4;
    benign.wrong = 500;  // not a hard ray's
    auto sliver = measured.rows[1];
    sliver.distribution = "sliver";
    sliver.wrong = 2;
    sliver.wrong_per_million = 2000;
    measured.rows = {benign, measured.rows[1], sliver};
    const std::string text = report::accuracy_text({measured, {}});
    // 14 of 2000.
    EXPECT_THAT(text, HasSubstr("* naive float       4.00             -          7,000  grazing 12,000\n"));
}

}  // namespace
