// The file that goes from one machine to another.
#include "harness/shards/part.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <tuple>

#include "harness/gradebook/record.h"
#include "tests/given/bytes_of.h"
#include "tests/given/message_of.h"

namespace harness {
namespace {

namespace fs = std::filesystem;

class PartFile : public testing::Test {
  protected:
    PartFile() {
        part.head = {{2, 5}, 10, 2, {{"raygrade", "1.2"}, {"sandbox", "bwrap+shim"}}};
        part.file = {"/a/b.toml", "title = \"x\"\n"};
        part.inputs = {{"canvas-roster", "Six", std::string("Student\xff\0,", 10)}};
        for (const std::size_t index : {std::size_t{3}, std::size_t{7}}) {
            IndexedGraded& one = part.graded.emplace_back();
            one.index = index;
            one.graded.submission.id = "s" + std::to_string(index);
            one.graded.submission.source = "int main() {}\n";
            one.graded.execution.printout = "Question 1:\n" + std::string(index, '\0');
        }
        write_part(part, file);
    }
    ~PartFile() override { fs::remove(file); }

    void put(const std::string& bytes) const { std::ofstream(file, std::ios::binary) << bytes; }
    /// What reading it throws; empty if nothing.
    std::string damage() const {
        const auto read = [&] {
            read_part_head(file);
            read_part(file);
        };
        return message_of<DamagedFile>(read, "");
    }

    const fs::path file = fs::temp_directory_path() / ("part-test." + std::to_string(getpid()));
    Part part;
};

TEST_F(PartFile, ContainsEverything) {
    const PartHead head = read_part_head(file);
    const Part read = read_part(file);
    EXPECT_EQ(std::tie(head.shard.number, head.shard.count, head.class_size), std::make_tuple(2, 5, 10U));
    EXPECT_EQ(head.alike, part.head.alike);
    EXPECT_EQ(std::tie(read.file.path, read.file.toml), std::tie(part.file.path, part.file.toml));
    ASSERT_EQ(read.inputs.size(), 1U);
    EXPECT_EQ(std::tie(read.inputs[0].name, read.inputs[0].choice, read.inputs[0].content),
              std::make_tuple("canvas-roster", "Six", part.inputs[0].content));
    ASSERT_EQ(read.graded.size(), 2U);
    EXPECT_EQ(read.graded[1].index, 7U);
    EXPECT_EQ(to_record(read.graded[1].graded), to_record(part.graded[1].graded));
    EXPECT_EQ(read.graded[1].graded.execution.printout, part.graded[1].graded.execution.printout);
    EXPECT_EQ(read.graded[1].graded.submission.source, "int main() {}\n");
}

TEST_F(PartFile, IsRefusedIfCutOffAnywhere) {
    const std::string whole = bytes_of(file);
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        put(whole.substr(0, size));
        EXPECT_NE(damage(), "") << size << " bytes";
    }
}

TEST_F(PartFile, IsRefusedIfAnyByteIsChanged) {
    const std::string whole = bytes_of(file);
    for (std::size_t at = 0; at < whole.size(); at += 7) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ (at % 2 == 0 ? '\x01' : '\x80'));
        put(changed);
        EXPECT_NE(damage(), "") << "at byte " << at;
    }
    put(whole + "x");
    EXPECT_NE(damage(), "");
    put(whole);
    EXPECT_EQ(damage(), "");
}

TEST_F(PartFile, IsRefusedIfItsPlaceIsOutsideTheClass) {
    part.graded[0].index = 10;
    write_part(part, file);
    EXPECT_EQ(damage(), "is not a part of a class, or is damaged; merge takes the files that grade --shard wrote");
}

TEST_F(PartFile, IsRefusedIfItsConditionsAreNotTexts) {
    for (const char* wrong : {"[]", "1", "null", R"({"a":1})", R"({"a":{}})"}) {
        part.head.alike = nlohmann::ordered_json::parse(wrong);
        write_part(part, file);
        EXPECT_EQ(damage(), "is not a part of a class, or is damaged; merge takes the files that grade --shard wrote")
            << wrong;
    }
}

TEST_F(PartFile, IsRefusedIfMissingOrNotAFile) {
    fs::remove(file);
    EXPECT_EQ(damage(), "does not exist; check the name");
    EXPECT_THROW(read_part_head(fs::temp_directory_path()), DamagedFile);
    EXPECT_THROW(read_part_head("/dev/zero"), DamagedFile);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_EQ(damage(), "cannot be read: it is a folder, pipe or device; name the files that grade --shard wrote")
        << "and not waited for";
}

}  // namespace
}  // namespace harness
