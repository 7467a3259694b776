#include "harness/intake/source_file.h"

#include <cerrno>
#include <system_error>

#include "harness/intake/not_a_source.h"
#include "harness/machine/hash.h"
#include "harness/text/lower_case.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

std::string problem_of(int error, const std::filesystem::path& file) {
    if (error == ELOOP)
        return in_quotes(file.filename()) +
               " is a symbolic link, and links are not followed. Put the file itself there.";
    const std::string reason = std::generic_category().message(error);
    const std::string way_out = error == EACCES ? " Make it readable: chmod u+r." : "";
    return "Cannot read " + in_quotes(file.filename()) + ": " + reason + '.' + way_out;
}

std::string too_large(const std::filesystem::path& file) {
    return in_quotes(file.filename()) + " is larger than " + std::to_string(largest_source_bytes >> 20) +
           " MiB and was not read. Hand in only the source, without data or output in it.";
}

}  // namespace

bool is_source_name(const std::filesystem::path& file) {
    const std::string ending = lower_case(file.extension().string());
    return ending == ".cpp" || ending == ".cc" || ending == ".cxx";
}

void set_source(Submission& submission, std::string bytes, bool is_too_large) {
    if (is_too_large) {
        submission.problem = too_large(submission.file);
        return;
    }
    if (const std::string why = why_no_source(bytes); !why.empty()) {
        submission.problem = in_quotes(submission.file.filename()) + ' ' + why;
        return;
    }
    // DOS editors end files with 0x1A, which no compiler accepts.
    if (const std::size_t end = bytes.find_last_not_of("\x1a\r\n"); bytes.find('\x1a', end + 1) != std::string::npos)
        bytes.replace(end + 1, std::string::npos, "\n");
    submission.source_sha256 = hex_of(sha256(bytes));
    submission.source = std::move(bytes);
}

void read_source(Submission& submission, Links links) {
    const auto& path = submission.file;
    BoundedFile file = read_bounded(path, largest_source_bytes, links);
    if (file.error != 0) {
        submission.problem = problem_of(file.error, path);
    } else if (file.is_special) {
        submission.problem =
            in_quotes(path.filename()) + " is a folder, pipe or device, not a file. Put the source itself there.";
    } else {
        set_source(submission, std::move(file.bytes), file.has_more);
    }
}

}  // namespace harness
