// The library that gives the compiler huge pages: a file that it copies must look like one that the kernel maps.
#include <dlfcn.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <string_view>

#include "harness/machine/file_descriptor.h"
#include "harness/machine/parts.h"
#include "tests/given/bytes_of.h"
#include "tests/given/temporary_folder.h"

namespace {

using Map = void* (*)(void*, std::size_t, int, int, int, off_t);

/// The library's mmap.
Map map_of_library() {
    void* const library = dlopen(harness::find_part("lib/raygrade/raygrade-huge-pages.so").c_str(), RTLD_NOW);
    if (library == nullptr) throw std::runtime_error(dlerror());
    return reinterpret_cast<Map>(dlsym(library, "mmap"));
}

constexpr std::size_t page = 4096, copied_size = std::size_t{3} << 20;

class HugePages : public testing::Test {
  protected:
    HugePages() {
        for (std::size_t i = 0; content.size() < copied_size + page; ++i) content += std::to_string(i);
        folder.write("file", content);
    }

    /// A writable private mapping of the file from its second page on.
    char* map(std::size_t size) const {
        static const Map library_map = map_of_library();
        const harness::FileDescriptor file(open((folder / "file").c_str(), O_RDONLY | O_CLOEXEC));
        return static_cast<char*>(library_map(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE, file.get(), page));
    }

    std::string content;
    TemporaryFolder folder;
};

TEST_F(HugePages, ContainAPrivateCopyOfTheFile) {
    char* const memory = map(copied_size);
    ASSERT_NE(memory, MAP_FAILED);
    EXPECT_EQ(std::string_view(memory, copied_size), std::string_view(content).substr(page, copied_size));
    memory[0] = '?';
    EXPECT_EQ(bytes_of(folder / "file"), content);
    munmap(memory, copied_size);
}

TEST_F(HugePages, EndAProgramThatReachesPastTheEndOfTheFile) {
    const std::size_t too_much = content.size() + 2 * page;
    volatile char* const memory = map(too_much);
    ASSERT_EQ(memory[0], content[page]);
    EXPECT_DEATH(memory[too_much - 1] = 1, "") << "as it does with the kernel's own mapping";
}

}  // namespace
