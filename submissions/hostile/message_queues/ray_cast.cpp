// Tries: System V and POSIX queues and semaphores, which outlive the process. Outcome: graded.
#include <fcntl.h>
#include <mqueue.h>
#include <sys/ipc.h>
#include <sys/msg.h>
#include <sys/sem.h>

#include <cstdio>

int main() {
    const int queue = msgget(IPC_PRIVATE, IPC_CREAT | 0600);
    if (queue >= 0) {
        std::printf("ESCAPED: msgget gave queue %d\n", queue);
        msgctl(queue, IPC_RMID, nullptr);
    }
    const int semaphore = semget(IPC_PRIVATE, 1, IPC_CREAT | 0600);
    if (semaphore >= 0) {
        std::printf("ESCAPED: semget gave semaphore %d\n", semaphore);
        semctl(semaphore, 0, IPC_RMID);
    }
    const mqd_t posix = mq_open("/raygrade-hostile", O_RDWR | O_CREAT, 0600, nullptr);
    if (posix != static_cast<mqd_t>(-1)) {
        std::puts("ESCAPED: mq_open gave a queue");
        mq_unlink("/raygrade-hostile");
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
