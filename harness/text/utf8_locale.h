// Reads names in archives as UTF-8, whatever the machine's language.
#pragma once

#include <clocale>

namespace harness {

/// Sets this thread's character encoding to UTF-8 while it lives. libarchive converts names by the thread's locale; in
/// the C locale it stops at the first name that is not ASCII.
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
