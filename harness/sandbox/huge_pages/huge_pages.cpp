// Preloaded into the compiler. It asks for huge pages for the memory that the compiler maps, and for the precompiled
// header, which it copies into such pages. A compiler computes the same in them, with a tenth of the page faults: g++
// 12 had twenty thousand for one submission, and six thousand for reading a header. On a virtual machine that was a
// third to a half of its processor time; where page faults cost little, it changes little.
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

void* map(void* address, std::size_t size, int protection, int flags, int file, off_t offset) {
    return reinterpret_cast<void*>(syscall(SYS_mmap, address, size, protection, flags, file, offset));
}

/// A wish only: without huge pages it changes nothing.
void wish_for_huge_pages(void* memory, std::size_t size) {
    const int before = errno;
    madvise(memory, size, MADV_HUGEPAGE);
    errno = before;
}

bool fill(char* memory, std::size_t size, int file, off_t offset) {
    while (size > 0) {
        const ssize_t got = pread(file, memory, size, offset);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        memory += got;
        offset += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

/// What a private mapping that may be written holds is its own from the first write on, so a copy does as well.
bool may_be_a_copy(std::size_t size, int protection, int flags) {
    return size >= huge_page && protection == (PROT_READ | PROT_WRITE) && flags == MAP_PRIVATE;
}

}  // namespace

extern "C" void* mmap(void* address, std::size_t size, int protection, int flags, int file, off_t offset) noexcept {
    const bool copies = file >= 0 && may_be_a_copy(size, protection, flags);
    void* const memory = copies ? map(address, size, protection, flags | MAP_ANONYMOUS, -1, 0)
                                : map(address, size, protection, flags, file, offset);
    if (memory == MAP_FAILED) return memory;
    if (copies || (flags & MAP_ANONYMOUS) != 0) wish_for_huge_pages(memory, size);
    if (!copies || fill(static_cast<char*>(memory), size, file, offset)) return memory;
    // Behind the end of a file that is too short, the kernel's mapping ends the compiler, and a copy would not.
    return map(memory, size, protection, flags | MAP_FIXED, file, offset);
}
