// Tries: bpf, perf_event_open, userfaultfd, 32-bit personality and process_madvise. Outcome: graded.
#include <linux/bpf.h>
#include <linux/perf_event.h>
#include <sys/personality.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>

void say(const char* what, long result) {
    if (result >= 0) std::printf("ESCAPED: %s worked\n", what);
}

int main() {
    bpf_attr map{};
    map.map_type = BPF_MAP_TYPE_ARRAY;
    map.key_size = map.value_size = 4;
    map.max_entries = 1;
    say("bpf", syscall(SYS_bpf, BPF_MAP_CREATE, &map, sizeof map));
    perf_event_attr event{};
    event.type = PERF_TYPE_SOFTWARE;
    event.size = sizeof event;
    event.config = PERF_COUNT_SW_CPU_CLOCK;
    event.exclude_kernel = 1;
    say("perf_event_open", syscall(SYS_perf_event_open, &event, 0, -1, -1, 0));
    say("userfaultfd", syscall(SYS_userfaultfd, 1 /* UFFD_USER_MODE_ONLY */));
    say("personality", personality(ADDR_NO_RANDOMIZE));
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
