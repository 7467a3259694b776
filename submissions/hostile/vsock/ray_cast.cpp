// Tries: a socket to the machine's host (AF_VSOCK), which a network namespace does not hide. Outcome: graded.
#include <sys/socket.h>

#include <cstdio>

int main() {
    // Not connected: whoever listens there is not to be disturbed by a test.
    if (socket(AF_VSOCK, SOCK_STREAM, 0) >= 0) std::puts("ESCAPED: there is an AF_VSOCK socket");
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
