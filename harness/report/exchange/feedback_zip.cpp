#include "harness/report/exchange/feedback_zip.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <ostream>

#include "harness/machine/errors.h"
#include "harness/report/page/student_page.h"
#include "harness/text/printable.h"
#include "harness/text/utf8.h"
#include "harness/text/utf8_locale.h"

namespace harness::report {
namespace {

constexpr const char* page_name = "feedback.html";

/// A student's name as part of a file's name, without separators of fields or paths; invalid bytes become %XX.
std::string safe_name(const std::string& name) {
    constexpr std::size_t longest = 100;
    std::string safe = printable(name);
    for (char& c : safe) {
        if (std::string_view("_/\\:*?\"<>|~").find(c) != std::string_view::npos) c = ' ';
    }
    safe.resize(beginning_of_characters(safe, longest).size());
    const std::size_t first = safe.find_first_not_of(". ");
    return first == std::string::npos ? "" : safe.substr(first);
}

bool is_number(const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_anonymous(const std::string& id) {
    constexpr std::string_view before = "anon_";
    return id.starts_with(before) && id.size() > before.size() &&
           std::all_of(id.begin() + before.size(), id.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
           });
}

/// Canvas's number of the graded file or, if unknown, of another file of the student: Canvas returns a page by any of
/// them.
std::string attachment_of(const Submission& submission) {
    const auto graded = read_canvas_name(submission.file.filename().string());
    const bool known = graded && graded->id == submission.lms->id && !graded->attachment.empty();
    return known ? graded->attachment : submission.lms->attachment;
}

std::string in_canvas(const LmsName& lms, const std::string& attachment) {
    std::string name = safe_name(lms.student);
    std::replace(name.begin(), name.end(), ' ', '-');
    if (is_number(name)) name = "student-" + name;
    if (!name.empty()) name += '_';
    return name + (lms.late == true ? "LATE_" : "") + lms.id + '_' + attachment + '_' + page_name;
}

std::string in_moodle(const LmsName& lms) {
    const std::string name = safe_name(lms.student);
    return fmt::format("{}_{}_assignsubmission_file/{}", name.empty() ? "Participant" : name, lms.id, page_name);
}

bool is_returned_to(const Submission& submission) {
    return submission.lms && submission.lms->system != Lms::gradescope;
}

class ZipWriter {
  public:
    explicit ZipWriter(std::ostream& out) : writer_(archive_write_new(), archive_write_free) {
        check(archive_write_set_format_zip(writer_.get()));
        // Pages shrink to a fifth at the fastest level, and hardly more at the slowest.
        check(archive_write_set_options(writer_.get(), "zip:hdrcharset=UTF-8,zip:compression-level=1"));
        check(archive_write_set_bytes_in_last_block(writer_.get(), 1));
        const auto write = [](archive*, void* stream, const void* bytes, std::size_t size) -> la_ssize_t {
            auto& to = *static_cast<std::ostream*>(stream);
            to.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
            return to ? static_cast<la_ssize_t>(size) : -1;
        };
        check(archive_write_open(writer_.get(), &out, nullptr, write, nullptr));
    }

    void add(const std::string& path, const std::string& bytes) {
        const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(), archive_entry_free);
        archive_entry_set_pathname(entry.get(), path.c_str());
        archive_entry_set_filetype(entry.get(), AE_IFREG);
        archive_entry_set_perm(entry.get(), 0644);
        archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes.size()));
        // An entry without a time gets 1980, the earliest time in a zip, in every time zone.
        check(archive_write_header(writer_.get(), entry.get()));
        if (archive_write_data(writer_.get(), bytes.data(), bytes.size()) != static_cast<la_ssize_t>(bytes.size()))
            check(ARCHIVE_FATAL);
    }

    void close() { check(archive_write_close(writer_.get())); }

  private:
    void check(int result) {
        if (result == ARCHIVE_OK) return;
        const char* why = archive_error_string(writer_.get());
        throw HarnessError(fmt::format("The zip of feedback can't be written: {}; is the disk full?",
                                       why == nullptr ? "writing failed" : why));
    }

    std::unique_ptr<archive, int (*)(archive*)> writer_;
};

}  // namespace

std::optional<std::string> way_back(const Submission& submission) {
    if (!is_returned_to(submission)) return std::nullopt;
    const LmsName& lms = *submission.lms;
    if (lms.system == Lms::moodle) return is_number(lms.id) ? std::optional(in_moodle(lms)) : std::nullopt;
    const std::string attachment = attachment_of(submission);
    const bool is_known = is_number(lms.id) || is_anonymous(lms.id);
    return is_known && is_number(attachment) ? std::optional(in_canvas(lms, attachment)) : std::nullopt;
}

bool is_from_lms(const std::vector<Graded>& graded) {
    return std::any_of(graded.begin(), graded.end(), [](const Graded& one) { return is_returned_to(one.submission); });
}

FeedbackZip write_feedback_zip(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking) {
    const Utf8Names names;
    std::map<std::pair<Lms, std::string>, int> submissions_of;
    for (const Graded& one : graded) {
        if (is_returned_to(one.submission)) ++submissions_of[{one.submission.lms->system, one.submission.lms->id}];
    }
    FeedbackZip zip;
    ZipWriter writer(out);
    for (const Graded& one : graded) {
        if (!is_returned_to(one.submission)) continue;
        const auto path = way_back(one.submission);
        if (submissions_of.at({one.submission.lms->system, one.submission.lms->id}) > 1) {
            zip.left_out.push_back(one.submission.id + ": another submission has the same number, " +
                                   one.submission.lms->id);
        } else if (!path) {
            zip.left_out.push_back(one.submission.id + ": Canvas has no file of this student to return the page with");
        } else {
            writer.add(*path, student_page(one, own_marking(marking, one.submission)));
            ++zip.pages;
        }
    }
    writer.close();
    return zip;
}

}  // namespace harness::report
