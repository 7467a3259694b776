#include "harness/report/page/listing.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/report/page/student_page.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/report/read_page.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(Listing, NumbersTheLinesOfAPrintoutAsTheReaderDoes) {
    const std::string output = "Question 6:\r\n\rt: \xff\n\nd: 3";  // "", "t: …" and "" are lines 2 to 4
    const Listing listing = Listing::of_printout(output, {}, "o");
    EXPECT_EQ(listing.html("Output"),
              "<pre class=\"listing\" tabindex=\"0\" role=\"region\" aria-label=\"Output\">"
              "<span id=\"o1\"><i>1</i>Question 6:\n</span><span id=\"o2\"><i>2</i>\n</span>"
              "<span id=\"o3\"><i>3</i>t: \\xff\n</span><span id=\"o4\"><i>4</i>\n</span>"
              "<span id=\"o5\"><i>5</i>d: 3\n</span></pre>\n");
    const Score score = graded("one", output).score;
    const auto d = std::find_if(score.questions[5].items.begin(), score.questions[5].items.end(),
                                [](const ItemScore& item) { return item.line == 5; });
    EXPECT_NE(d, score.questions[5].items.end()) << "the reader finds d in line 5 too";
}

TEST(Listing, CountsTheLinesOfASourceAsACompilerDoes) {
    const Listing listing = Listing::of_source("int a;\r\nint\rb;\n", {{2, {{"unused", "warning"}}}}, "c");
    EXPECT_THAT(listing.html("Source"),
                AllOf(HasSubstr("<span id=\"c1\"><i>1</i>int a;\n</span>"),
                      HasSubstr("<span id=\"c2\" class=\"warning\"><i>2</i>int\\x0db; "
                                "<span class=\"verdict warning\">unused</span>\n</span></pre>")));
    EXPECT_TRUE(listing.has_anchor(2));
    EXPECT_FALSE(listing.has_anchor(3));
}

TEST(Listing, ShowsHostileTextAsText) {
    const std::string evil = "</pre><script>alert(1)</script> \x1b[31m\xe2\x80\xae{{x}} \"'&";
    const std::string html = Listing::of_printout(evil, {{1, {{evil, "wrong"}}}}, "o").html(evil);
    EXPECT_THAT(html, AllOf(Not(HasSubstr("<script")), Not(HasSubstr("\x1b")), Not(HasSubstr("\xe2\x80\xae"))));
    EXPECT_EQ(count(html, "&lt;/pre&gt;&lt;script&gt;alert(1)&lt;/script&gt; \\x1b[31m\\u202e{{x}} &quot;&#39;&amp;"),
              3U);
}

TEST(Listing, IsBoundedAndSaysWhereItIsCut) {
    std::string many;
    for (int i = 1; i <= 30; ++i) many += "x\n";
    const Listing by_lines = Listing::of_printout(many, {}, "o", {10, 1000});
    EXPECT_THAT(by_lines.html(""),
                AllOf(HasSubstr("id=\"o10\""), Not(HasSubstr("id=\"o11\"")), HasSubstr("Cut after line 10.")));
    EXPECT_FALSE(by_lines.has_anchor(11)) << "no link leads to what is not there";
    EXPECT_THAT(Listing::of_printout(many, {}, "o", {1000, 10}).html(""), HasSubstr("Cut after line 5."));
    EXPECT_THAT(Listing::of_printout(many, {}, "o", {30, 60}).html(""), Not(HasSubstr("Cut")));
    EXPECT_THAT(Listing::of_printout(many, {}, "o", {0, 0}).html(""),
                "<p class=\"facts\">Left out because the page would be too long.</p>\n");
    const std::string wide = Listing::of_source(std::string(100000, 'w'), {}, "c").html("");
    EXPECT_LT(wide.size(), 700U);
    EXPECT_THAT(wide, HasSubstr("w…\n"));
    EXPECT_TRUE(Listing::of_printout("", {}, "o").html("").empty());
}

TEST(Listing, LinksTheLinesThatASentenceNames) {
    const Listing listing = Listing::of_printout("a\nb\n", {}, "s3-o");
    EXPECT_EQ(listing.with_links("<6.t>: line 2 has numbers; also on line 3, in line x, in outline 1 and Line 1"),
              "&lt;6.t&gt;: <a href=\"#s3-o2\">line 2</a> has numbers; also on line 3, in line x, in outline 1 and <a "
              "href=\"#s3-o1\">Line 1</a>");
    EXPECT_EQ(Listing().with_links("line 1"), "line 1");
    EXPECT_THAT(lines_named("6.t in line 20, 6.d in line 7"), ElementsAre(20, 7));
}

TEST(Listing, ALineIsColouredByItsWorstAnswerAndAllLinesOfAMatrixAre) {
    Score score = graded("one", "").score;
    ItemScore& matrix = score.questions[2].items[0];
    matrix.verdict = ItemVerdict::right;
    matrix.line = 2;
    matrix.last_line = 3;
    ItemScore& wrong = score.questions[5].items[0];
    wrong.verdict = ItemVerdict::wrong;
    wrong.line = wrong.last_line = 3;
    const std::string html =
        Listing::of_printout("Question 3:\n1 0\n0 1 a: 9\n", notes_of_answers(score), "o").html("");
    EXPECT_THAT(html, HasSubstr("<span id=\"o1\"><i>1</i>Question 3:\n</span>"));
    EXPECT_THAT(
        html,
        HasSubstr(
            "<span id=\"o2\" class=\"right\"><i>2</i>1 0 <span class=\"verdict right\">3.M_VCS_to_WCS right</span>\n"));
    EXPECT_THAT(
        html,
        HasSubstr("<span id=\"o3\" class=\"wrong\"><i>3</i>0 1 a: 9 <span class=\"verdict wrong\">6.a wrong</span>\n"));
}

TEST(Listing, OfAStudentsPageSaysIfThePrintoutIsTooLong) {
    const Graded one = graded("s01", output_with_a_mistake());  // without its printout, as one above 64 KiB
    EXPECT_THAT(read_page(student_page(one, marking())).at("text"), HasSubstr("The output was too long to keep"));
    EXPECT_THAT(read_page(student_page(graded("nil", ""), marking())).at("text"), Not(HasSubstr("too long")));
}

TEST(SourceLine, IsALineWithoutTheBlanksAroundIt) {
    EXPECT_EQ(source_line("a\r\n\t b c \r\n", 2), "b c");
    EXPECT_EQ(source_line("a\n\n", 2), "");
    EXPECT_EQ(source_line("a", 2), "");
    EXPECT_EQ(source_line("a", 0), "");
}

}  // namespace
}  // namespace harness::report
