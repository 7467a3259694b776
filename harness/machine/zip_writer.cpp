#include "harness/machine/zip_writer.h"

#include <archive.h>
#include <archive_entry.h>

#include <ostream>

#include "harness/machine/errors.h"

namespace harness {

ZipWriter::ZipWriter(std::ostream& out) : out_(out), writer_(archive_write_new(), archive_write_free) {
    check(archive_write_set_format_zip(writer_.get()));
    // Pages shrink to a fifth at the fastest level, and hardly more at the slowest one.
    check(archive_write_set_options(writer_.get(), "zip:hdrcharset=UTF-8,zip:compression-level=1"));
    check(archive_write_set_bytes_in_last_block(writer_.get(), 1));
    // libarchive 3.6 leaks the compressor of an entry that it fails to write, so this function never fails, and errors
    // are read from the stream.
    const auto write = [](archive*, void* stream, const void* bytes, std::size_t size) {
        static_cast<std::ostream*>(stream)->write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
        return static_cast<la_ssize_t>(size);
    };
    check(archive_write_open(writer_.get(), &out, nullptr, write, nullptr));
}

void ZipWriter::add(const std::string& path, std::string_view bytes, Mode mode) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
    archive_entry_set_pathname(entry.get(), path.c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), mode == Mode::executable ? 0755 : 0644);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
    // An entry without a time gets 1980, the earliest time in a zip, whatever the time zone.
    check(archive_write_header(writer_.get(), entry.get()));
    const auto written = archive_write_data(writer_.get(), bytes.data(), bytes.size());
    check(written == static_cast<la_ssize_t>(bytes.size()) ? ARCHIVE_OK : ARCHIVE_FATAL);
}

void ZipWriter::close() {
    check(archive_write_close(writer_.get()));
}

void ZipWriter::check(int result) {
    if (result == ARCHIVE_OK && out_) return;
    const char* why = archive_error_string(writer_.get());
    throw HarnessError(std::string("Cannot write the zip: ") + (why == nullptr ? "writing failed" : why) +
                       "; is the disk full?");
}

}  // namespace harness
