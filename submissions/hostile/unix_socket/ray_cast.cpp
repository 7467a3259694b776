// Tries: to talk to a process outside through an abstract Unix socket. Outcome: graded.
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <cstring>

int main() {
    const int connection = socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const char name[] = "raygrade-decoy";
    std::memcpy(address.sun_path + 1, name, sizeof name - 1);
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + sizeof name);
    if (connection >= 0 && connect(connection, reinterpret_cast<sockaddr*>(&address), size) == 0) {
        std::puts("ESCAPED: connected to the abstract socket raygrade-decoy");
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
