#include "harness/machine/zip_writer.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "harness/machine/errors.h"
#include "tests/given/temporary_folder.h"

namespace harness {
namespace {

std::string zip_of_two() {
    std::ostringstream bytes;
    ZipWriter zip(bytes);
    zip.add("setup.sh", "echo ready\n", ZipWriter::Mode::executable);
    zip.add("text/zoë.md", std::string(100'000, 'a'));
    zip.close();
    return bytes.str();
}

TEST(Zip, IsReadBackWithModesAndNames) {
    const TemporaryFolder folder;
    const auto file = folder.write("two.zip", zip_of_two());
    const std::string command =
        "python3 -c 'import sys, zipfile\nz = zipfile.ZipFile(sys.argv[1])\nassert z.testzip() is None\n"
        "for i in z.infolist(): print(i.filename, oct(i.external_attr >> 16), i.file_size, i.date_time[0])' " +
        file.string() + " > " + (folder.path() / "read").string();
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ostringstream read;
    read << std::ifstream(folder.path() / "read").rdbuf();
    EXPECT_EQ(read.str(), "setup.sh 0o100755 11 1980\ntext/zoë.md 0o100644 100000 1980\n");
}

TEST(Zip, HasTheSameBytesEachTime) {
    EXPECT_EQ(zip_of_two(), zip_of_two());
}

TEST(Zip, ReportsThatItCannotBeWritten) {
    std::ofstream full("/dev/full");
    const auto write = [&] {
        ZipWriter zip(full);
        for (int i = 0; i < 100; ++i) zip.add("file" + std::to_string(i), std::string(100'000, static_cast<char>(i)));
        zip.close();
        full.flush();
        if (!full) throw HarnessError("Cannot write the zip");
    };
    EXPECT_THROW(write(), HarnessError);
}

}  // namespace
}  // namespace harness
