#include "harness/sandbox/supervisor/process_tree.h"

#include <gmock/gmock.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <limits>

namespace {

using harness::below;
using harness::list_processes;
using harness::list_processes_except;
using harness::ProcessRecord;

ProcessRecord record(pid_t pid, pid_t parent) {
    ProcessRecord process;
    process.pid = pid;
    process.parent = parent;
    return process;
}

std::vector<pid_t> pids(const std::vector<ProcessRecord>& processes) {
    std::vector<pid_t> all;
    for (const auto& process : processes) all.push_back(process.pid);
    return all;
}

TEST(Below, FindsExactlyTheWholeTree) {
    const std::vector<ProcessRecord> processes = {record(1, 0), record(5, 1), record(9, 5), record(3, 9), record(7, 1)};
    EXPECT_THAT(pids(below(5, processes)), testing::UnorderedElementsAre(9, 3));
    EXPECT_THAT(pids(below(7, processes)), testing::IsEmpty());
}

TEST(Below, EndsIfParentsFormACircle) {
    EXPECT_LE(below(5, {record(6, 5), record(5, 6)}).size(), 4U);
}

TEST(ListProcesses, ReadsANameWithBlanksAndParentheses) {
    prctl(PR_SET_NAME, ") R 1 (x y");
    const auto all = list_processes();
    prctl(PR_SET_NAME, "harness_machine");
    const auto self = std::find_if(all.begin(), all.end(), [](const auto& process) { return process.pid == getpid(); });
    ASSERT_NE(self, all.end());
    EXPECT_EQ(self->parent, getppid());
    EXPECT_EQ(self->group, getpgrp());
    EXPECT_GT(self->memory_bytes, 1U << 20);
    EXPECT_GE(self->threads, 1);
    EXPECT_FALSE(self->zombie);
}

TEST(ListProcesses, LeavesOutSkippedProcesses) {
    std::vector<pid_t> strangers = {getpid(), std::numeric_limits<pid_t>::max()};
    EXPECT_THAT(pids(list_processes_except(strangers)), testing::Not(testing::Contains(getpid())));
    EXPECT_THAT(strangers, testing::ElementsAre(getpid())) << "the number of one that is gone may be given to another";
}

TEST(KillBelow, KillsChildrenButNeverTheCallersOwnGroup) {
    const pid_t same_group = fork();
    if (same_group == 0) {
        pause();
        _exit(0);
    }
    const pid_t own_session = fork();
    if (own_session == 0) {
        setsid();
        pause();
        _exit(0);
    }
    harness::kill_below(getpid());
    for (const pid_t child : {same_group, own_session}) {
        int status = 0;
        EXPECT_EQ(waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    }
}

}  // namespace
