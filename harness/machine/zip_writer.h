// Writes a zip, entry by entry.
#pragma once

#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

#include "harness/text/utf8_locale.h"

struct archive;

namespace harness {

/// The same entries give the same bytes at any time and on any machine: entries have no time of their own.
class ZipWriter {
  public:
    enum class Mode { plain, executable };

    /// Writes to `out`, which must outlive this. Names are UTF-8, and so is this thread's encoding while this object
    /// exists. Throws HarnessError.
    explicit ZipWriter(std::ostream& out);

    /// Adds a file under the relative path `path`. Throws HarnessError.
    void add(const std::string& path, std::string_view bytes, Mode mode = Mode::plain);

    /// Writes the zip's directory, without which the file is not a zip. Throws HarnessError.
    void close();

  private:
    void check(int result);

    std::ostream& out_;
    Utf8Names names_;
    std::unique_ptr<archive, int (*)(archive*)> writer_;
};

}  // namespace harness
