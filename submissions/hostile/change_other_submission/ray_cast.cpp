// Tries: to rename, remove, empty, re-date and chmod another submission. Outcome: graded.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>

void say(const char* what, bool worked) {
    if (worked) std::printf("ESCAPED: %s worked on another submission\n", what);
}

int main() {
    const char* other = "/tmp/raygrade-decoy/other/ray_cast.cpp";
    const char* moved = "/tmp/raygrade-decoy/other/moved.cpp";
    struct stat before {};
    stat(other, &before);
    const timespec times[2] = {before.st_atim, before.st_mtim};
    say("chmod", chmod(other, before.st_mode & 07777) == 0);  // to what it is: others are grading with it
    say("utimensat", utimensat(AT_FDCWD, other, times, 0) == 0);
    say("truncate", truncate(other, before.st_size) == 0);
    say("link", link(other, moved) == 0);
    say("unlink", unlink(moved) == 0);
    say("mkdir", mkdir("/tmp/raygrade-decoy/other/folder", 0755) == 0);
    say("rmdir", rmdir("/tmp/raygrade-decoy/other/folder") == 0);
    say("rename", rename(other, moved) == 0 && rename(moved, other) == 0);
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
