// Root reads and removes everything; a test of permissions has to look as somebody else.
#pragma once

#include <unistd.h>

/// While it lives, this process has the rights of an ordinary user, also when root runs the tests.
class AsNobody {
  public:
    AsNobody() { changed_ = user_ == 0 && seteuid(65534) == 0; }
    ~AsNobody() {
        if (changed_ && seteuid(user_) != 0) _exit(1);
    }
    AsNobody(const AsNobody&) = delete;
    AsNobody& operator=(const AsNobody&) = delete;

  private:
    uid_t user_ = geteuid();
    bool changed_ = false;
};
