// Trying in a child what can't be taken back.
#pragma once

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/// What `work`, a function that returns 0 to 200, returns in a child that may gain no privileges; 255 when a signal
/// ended it.
template <class Work>
int in_a_child(const Work& work) {
    const pid_t child = fork();
    if (child == 0) _exit(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 ? work() : 254);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) return 253;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 255;
}
