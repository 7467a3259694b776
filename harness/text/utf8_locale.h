// Names in archives are UTF-8, whatever the machine's language.
#pragma once

#include <clocale>

namespace harness {

/// While it lives, this thread's names are UTF-8: libarchive converts names by the thread's locale, and stops at the
/// first that is not ASCII in the C locale.
class Utf8Names {
  public:
    Utf8Names() : utf8_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)), before_(uselocale(utf8_)) {}
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;
    ~Utf8Names() {
        uselocale(before_);
        if (utf8_ != nullptr) freelocale(utf8_);
    }

  private:
    locale_t utf8_, before_;
};

}  // namespace harness
