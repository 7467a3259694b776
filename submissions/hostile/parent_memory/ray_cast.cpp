// Tries: to read the supervisor's memory through /proc and process_vm_readv. Outcome: graded.
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

int main() {
    const std::string parent = "/proc/" + std::to_string(getppid());
    for (const char* name : {"/mem", "/maps", "/auxv", "/stack", "/syscall"}) {
        const int file = open((parent + name).c_str(), O_RDONLY);
        char byte = 0;
        // mem has nothing at address 0: that it opens says enough.
        if (file >= 0 && (name == std::string("/mem") || read(file, &byte, 1) == 1)) {
            std::printf("ESCAPED: read %s%s\n", parent.c_str(), name);
        }
    }
    char byte = 0;
    iovec here = {&byte, 1};
    iovec there = {reinterpret_cast<void*>(0x400000), 1};
    const ssize_t size = process_vm_readv(getppid(), &here, 1, &there, 1, 0);
    if (size == 1 || errno == EFAULT) std::puts("ESCAPED: process_vm_readv may read the parent");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
