// Tries: to fill memory with the kernel's page tables, by looking at one byte in every 2 MiB. Outcome: memory_limit or timed_out.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

int main() {
    constexpr std::size_t step = std::size_t{2} << 20, tables = 150'000;  // 4 KiB each: 586 MiB
    void* nothing = mmap(nullptr, step * tables, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (nothing == MAP_FAILED) return 1;
    madvise(nothing, step * tables, MADV_NOHUGEPAGE);
    int sum = 0;
    for (std::size_t i = 0; i < tables; ++i) sum += static_cast<volatile char*>(nothing)[i * step];
    usleep(100000);
    std::printf("ESCAPED: looked at %zu pages of zeros (%d)\n", tables, sum);
}
