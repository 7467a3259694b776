// Tries: to leave a message in the user's keyring, which all programs of the user share. Outcome: graded.
#include <linux/keyctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>

int main() {
    const long key = syscall(SYS_add_key, "user", "raygrade-hostile", "message", 7, KEY_SPEC_USER_KEYRING);
    if (key >= 0) {
        std::printf("ESCAPED: key %ld is in the user's keyring\n", key);
        syscall(SYS_keyctl, KEYCTL_UNLINK, key, KEY_SPEC_USER_KEYRING);
    }
    if (syscall(SYS_keyctl, KEYCTL_GET_KEYRING_ID, KEY_SPEC_USER_KEYRING, 1) >= 0) {
        std::puts("ESCAPED: keyctl gave the user's keyring");
    }
    std::puts("Question 1\nP_VCS = (0.00, 0.00, -2.00)");
}
