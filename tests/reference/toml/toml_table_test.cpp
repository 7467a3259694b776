#include "reference/toml/toml_table.h"

#include <gmock/gmock.h>

#include <string>

#include "reference/toml/assignment_error.h"
#include "tests/given/message_of.h"

namespace reference {
namespace {

using testing::StartsWith;

std::string complaint_about_document(const std::string& toml) {
    return message_of<AssignmentError>([&] { TomlDocument(toml, "a.toml"); }, "accepted");
}

TEST(TomlDocument, RefusesCharactersBeyondAsciiOutsideQuotesAndComments) {
    EXPECT_THAT(complaint_about_document("a = 1\nb = [1, Т]"),
                StartsWith("a.toml:2:9: not valid TOML: only quoted texts"));
    EXPECT_THAT(complaint_about_document("größe = 1"), StartsWith("a.toml:1:3: not valid TOML"));
    EXPECT_THAT(complaint_about_document("a = \"\"\"x\"\"\"\"\"\nb = é"), StartsWith("a.toml:2:5: not valid TOML"));
    EXPECT_THAT(complaint_about_document("a = 'it''s' # 'é'\nb = \"\\\"\" é"),
                StartsWith("a.toml:2:10: not valid TOML"));
}

TEST(TomlDocument, AcceptsCharactersBeyondAsciiInQuotesAndComments) {
    for (const std::string text : {"# größe\na = 1", "a = \"größe \\\" é\"", "'größe' = 'é'",
                                   "a = \"\"\"é\n\"é\"\n\\\"\"\"é\"\"\"", "a = '''é\n''é'''''",
                                   "\xEF\xBB\xBF"
                                   "a = 1"}) {
        EXPECT_EQ(complaint_about_document(text), "accepted") << text;
    }
}

TEST(TomlDocument, ReportsThePlaceOfInvalidToml) {
    for (const std::string text : {"[[[", "a = \"", "a = '''", "a = \"\"\"\\", "a", "= 1", "\"", "'"}) {
        EXPECT_THAT(complaint_about_document(text), StartsWith("a.toml:1:")) << text;
    }
}

}  // namespace
}  // namespace reference
