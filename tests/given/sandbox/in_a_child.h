// Runs in a child process what can't be undone in the process itself.
#pragma once

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/// Calls `work`, which returns 0 to 200, in a child process that may gain no privileges. Returns its result, or 255 if
/// a signal ended the child.
template <class Work>
int in_a_child(const Work& work) {
    const pid_t child = fork();
    if (child == 0) _exit(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 ? work() : 254);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child) return 253;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 255;
}
