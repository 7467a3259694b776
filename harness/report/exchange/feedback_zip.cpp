#include "harness/report/exchange/feedback_zip.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ostream>

#include "harness/machine/zip_writer.h"
#include "harness/report/page/student_page.h"
#include "harness/text/printable.h"
#include "harness/text/utf8.h"

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

/// Canvas's number of the graded file. If it is unknown, the number of another file of the student: Canvas returns a
/// page by any of them.
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
    return submission.lms && (submission.lms->system == Lms::canvas || submission.lms->system == Lms::moodle);
}

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
    return std::any_of(graded.begin(), graded.end(),
                       [](const Graded& result) { return is_returned_to(result.submission); });
}

FeedbackZip write_feedback_zip(std::ostream& out, const std::vector<Graded>& graded, const Marking& marking) {
    std::map<std::pair<Lms, std::string>, int> submissions_of;
    for (const Graded& result : graded) {
        if (is_returned_to(result.submission))
            ++submissions_of[{result.submission.lms->system, result.submission.lms->id}];
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
            zip.left_out.push_back(one.submission.id +
                                   ": Canvas has no file from this student, so the page can't be returned");
        } else {
            writer.add(*path, student_page(one, own_marking(marking, one.submission)));
            ++zip.pages;
        }
    }
    writer.close();
    return zip;
}

}  // namespace harness::report
