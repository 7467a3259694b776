// Tries: to send what it knows to a listener on this machine. Outcome: graded.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdio>

int main() {
    const int tcp = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(47053);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (tcp >= 0 && connect(tcp, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) {
        std::puts("ESCAPED: connected to 127.0.0.1:47053");
        if (write(tcp, "answers\n", 8) < 0) std::perror("write");
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
