#include "harness/read/lines/tags.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

TEST(WithoutTags, ReadsAnElementAsALabelAndItsValue) {
    EXPECT_EQ(without_tags("<?xml version=\"1.0\"?>\n<question number=\"2\">\n  <a>1</a>\n  <m>\n    <row>1 0 0</row>\n"
                           "  </m>\n</question>\n"),
              "\nQuestion 2:\na: 1\nm:\n1 0 0\n\n\n");
    EXPECT_EQ(without_tags("<a>1</a>\n<b>2</b>\n<t>none</t>"), "a: 1\nb: 2\nt: none");
}

TEST(WithoutTags, ReadsHtmlAsItIsShown) {
    EXPECT_EQ(without_tags("<h2>Question 2</h2>\n<p>V<sub>s</sub> = 1<br>b = &minus;4<br/></p>\n<!-- t = 3 -->\n"),
              "Question 2; \nV_s = 1; b = -4; ; \n\n");
    EXPECT_EQ(without_tags("<ol start=\"6\">\n<li>a = 1</li>\n<LI>b</LI>\n</ol>\n<ul><li>c</li></ul>\n"),
              "\n6) a = 1; \n7) b; \n\nc; \n");
    EXPECT_EQ(without_tags("<ol>\n<li>a<ul><li>x</li></ul></li>\n<li>b</li></ol>\n"), "\n1) a; x; ; \n2) b; \n")
        << "a list in a list";
    EXPECT_EQ(without_tags("t = 1\n<!-- t = 2\n t = 3 -->u = 1\n<script>x</script>\n"), "t = 1\n\nu = 1\n\n");
    EXPECT_EQ(without_tags("<table><tr><td>a</td><td>1</td></tr></table>"), "  a  1; ");
}

TEST(WithoutTags, LeavesOtherTextAlone) {
    for (const char* text : {"", "\n", "V = <0, 0, -1>\n", "<a>1</a>\nt: 2\n", "<hit>\nt: 2\n", "a < b > c\n"})
        EXPECT_EQ(without_tags(text), text);
    EXPECT_EQ(without_tags("<?xml?>\n<P x=\"1\" y=\"2\" z=\"3\"/>\n<a>1</b>\n"),
              "\n<P x=\"1\" y=\"2\" z=\"3\"/>\n<a>1</b>\n");
}

}  // namespace
}  // namespace harness
