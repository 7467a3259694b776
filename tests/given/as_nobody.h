// Root may read and remove everything, so a test of permissions must give up root's rights.
#pragma once

#include <unistd.h>

/// Gives this process the rights of an ordinary user while the object lives, even if root runs the tests.
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
