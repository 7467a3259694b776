#include "harness/read/tags.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

TEST(WithoutTags, ReadsAnElementAsALabelAndItsValue) {
    EXPECT_EQ(without_tags("<?xml version=\"1.0\"?>\n<question number=\"2\">\n  <a>1</a>\n  <m>\n    <row>1 0 0</row>\n"
                           "  </m>\n</question>\n"),
              "\nQuestion 2:\na: 1\nm:\n1 0 0\n\n\n");
    EXPECT_EQ(without_tags("<a>1</a>\n<b>2</b>\n<t>none</t>"), "a: 1\nb: 2\nt: none");
}

TEST(WithoutTags, LeavesOtherTextAlone) {
    for (const char* text : {"", "\n", "V = <0, 0, -1>\n", "<a>1</a>\nt: 2\n", "<hit>\nt: 2\n", "a < b > c\n"})
        EXPECT_EQ(without_tags(text), text);
    EXPECT_EQ(without_tags("<?xml?>\n<P x=\"1\" y=\"2\" z=\"3\"/>\n<a>1</b>\n"),
              "\n<P x=\"1\" y=\"2\" z=\"3\"/>\n<a>1</b>\n");
}

}  // namespace
}  // namespace harness
