// Tries: to use 1 GiB of memory that is mapped nowhere, so that no process seems to have it. Outcome: graded.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

int main() {
    constexpr std::size_t size = 1 << 30, piece = 1 << 20;
    void* shared = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared != MAP_FAILED) {
        for (std::size_t at = 0; at < size; at += piece) {
            char* here = static_cast<char*>(shared) + at;
            std::memset(here, 1, piece);
            madvise(here, piece, MADV_DONTNEED);  // the page is forgotten here, and kept by the kernel
        }
        std::printf("ESCAPED: 1 GiB is in use, and its first byte is %d\n", *static_cast<char*>(shared));
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
