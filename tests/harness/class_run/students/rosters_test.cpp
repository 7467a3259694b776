#include "harness/class_run/students/rosters.h"

#include <gmock/gmock.h>

#include "harness/machine/errors.h"
#include "tests/given/message_of.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

TEST(RosterText, IsUtf8AlsoIfWindowsWroteIt) {
    const TemporaryFolder folder;
    EXPECT_EQ(read_roster_text(folder.write("a.csv", "Student,ID\nM\xfcller,1\n")), "Student,ID\nM\u00fcller,1\n");
    EXPECT_EQ(read_roster_text(folder.write("b.csv", "\xef\xbb\xbfM\u00fcller")), "\xef\xbb\xbfM\u00fcller");
    EXPECT_EQ(read_roster_text(folder.write("c.csv", "Mu\u0308ller")), "Mu\u0308ller") << "no other byte changes";
}

TEST(RosterText, IsRefusedWithItsTypeIfItIsNotCsv) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& bytes) {
        return message_of<UsageError>([&] { read_roster_text(folder.write("a.csv", bytes)); }, "no UsageError");
    };
    EXPECT_THAT(refusal("\xff\xfeS\0"s), HasSubstr("a.csv is saved as UTF-16; save it as CSV in UTF-8"));
    EXPECT_THAT(refusal("\xfe\xff\0S"s), HasSubstr("UTF-16"));
    EXPECT_THAT(refusal("PK\x03\x04\x14\0[Content_Types].xml"s), HasSubstr(".xlsx"));
    EXPECT_THAT(refusal("PK\x03\x04mimetypeapplication/vnd.oasis.opendocument.spreadsheet"), HasSubstr(".ods"));
    EXPECT_THAT(refusal("\xd0\xcf\x11\xe0\xa1\xb1"), HasSubstr(".xls"));
}

}  // namespace
}  // namespace harness
