#include "harness/intake/lms/lms_name.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <vector>

#include "harness/intake/archive_contents.h"
#include "harness/intake/lms_download.h"
#include "harness/intake/source_file.h"
#include "harness/text/printable.h"
#include "harness/text/utf8.h"
#include "tests/fuzz/properties.h"

namespace {

using harness::Lms;
using harness::LmsName;
using std::filesystem::path;

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const harness::Decoded decoded = harness::decode(text);
        if (decoded.code == harness::replacement && decoded.bytes == 1) return false;
        text.remove_prefix(decoded.bytes);
    }
    return true;
}

/// As the system writes it.
std::string written(const LmsName& name) {
    if (name.system == Lms::gradescope) return "submission_" + name.id;
    if (name.system == Lms::canvas) {
        return (name.student.empty() ? "" : name.student + "_") + (name.late == true ? "LATE_" : "") + name.id + "_" +
               (name.is_file ? name.attachment + "_" + name.file : name.file);
    }
    return name.student + "_" + name.id + "_assignsubmission_" + (name.is_file ? "file" : "onlinetext") +
           (name.file.empty() ? "" : "_" + name.file);
}

bool is_written_as(const LmsName& reading, std::string_view name) {
    const std::string text = written(reading);
    // A student without a name may have left the '_' behind it, and a folder may end in one.
    return text == name || (reading.student.empty() && "_" + text == name) ||
           (reading.system == Lms::moodle && reading.file.empty() && text + "_" == name);
}

std::string check_readings(std::string_view name, const std::vector<LmsName>& readings) {
    if (readings.size() > harness::most_readings) return "more readings than the limit";
    for (const LmsName& reading : readings) {
        if (!is_written_as(reading, name)) return "a reading that is not the name";
        const bool is_anonymous = reading.id.starts_with("anon_") && reading.id.size() > 5;
        if (!is_number(reading.id) && (reading.system != Lms::canvas || !is_anonymous))
            return "a number that is none: " + reading.id;
        if (reading.system == Lms::canvas && reading.is_file != is_number(reading.attachment))
            return "a file without a number, or a text with one";
    }
    return {};
}

bool is_among(const LmsName& name, const std::vector<LmsName>& readings) {
    return readings.size() == harness::most_readings ||
           std::any_of(readings.begin(), readings.end(), [&](const LmsName& reading) {
               return reading.student == name.student && reading.id == name.id && reading.file == name.file &&
                      reading.attachment == name.attachment && reading.late == name.late &&
                      reading.is_file == name.is_file;
           });
}

/// Writes names with this student or file in them, as the systems do.
std::string check_written(const std::string& text) {
    if (text.empty() || !is_utf8(text) || text.find('\0') != std::string::npos) return {};
    // Canvas writes a student's name in lower case, and '_' only before what follows the name.
    const bool is_of_canvas = text.find("LATE") == std::string::npos && text.find("anon") == std::string::npos;
    for (const bool late : {false, true}) {
        for (const auto& [student, file] : {std::pair<std::string, std::string>{text, "ray_cast.cpp"},
                                            std::pair<std::string, std::string>{"doejane", text}}) {
            const LmsName canvas{Lms::canvas, student, "4711", "70815", file, late};
            if (is_of_canvas && !is_among(canvas, harness::canvas_readings(written(canvas))))
                return "a name of Canvas is read otherwise than it was written";
            const LmsName moodle{Lms::moodle, student, "4711", "", file, std::nullopt};
            if (!is_among(moodle, harness::moodle_readings(written(moodle))))
                return "a name of Moodle is read otherwise than it was written";
        }
    }
    return {};
}

std::string check_base_name(const std::string& name) {
    const harness::BaseName base = harness::read_base_name(name);
    if (base.turn < 0) return "a turn below 0";
    if (base.name.size() == name.size()) return base.name == name ? "" : "a base name that is another";
    const std::size_t point = base.name.rfind('.');
    const std::size_t ending = base.name.size() - point;
    if (point == std::string::npos || point == 0 || !name.starts_with(base.name.substr(0, point)) ||
        !name.ends_with(base.name.substr(point))) {
        return "a base name of other letters";
    }
    const std::string between = name.substr(point, name.size() - point - ending);
    if (between.find_first_not_of("-( )0123456789") != std::string::npos) return "letters lost from a base name";
    const std::size_t digits = between.find_first_of("0123456789");
    if (digits == std::string::npos || std::stol(between.substr(digits)) != base.turn) return "a turn that is another";
    return {};
}

/// A download of nothing but the names of its files.
class Names final : public harness::FileTree {
  public:
    harness::Contents list(const path& /*folder*/) const override { return {}; }
    void read(harness::Submission& submission, harness::Links /*links*/) const override { submission.source = "int"; }
    harness::BoundedFile read(const path& /*file*/, std::uintmax_t /*most*/) const override { return {}; }
    std::string refusal(const path& /*place*/) const override { return {}; }
    std::unique_ptr<harness::FileTree> open(const path& /*archive*/) const override {
        throw harness::ArchiveError("empty");
    }
};

/// What a file of the download may be; nothing for a file that no student has handed in.
std::vector<LmsName> readings_of(const path& file, Lms system) {
    const std::string name = file.filename();
    if (system == Lms::canvas) return harness::canvas_readings(name);
    auto readings = harness::moodle_readings(name);
    std::erase_if(readings, [](const LmsName& read) { return read.file.empty(); });
    return readings;
}

/// Whether Canvas's own numbers of other files tell that this is not its number of a file.
bool is_short(const LmsName& reading, const std::vector<path>& files) {
    return std::any_of(files.begin(), files.end(), [&](const path& file) {
        const auto certain = readings_of(file, Lms::canvas);
        return certain.size() == 1 && certain[0].attachment.size() > reading.attachment.size() + 1;
    });
}

std::string check_submission(const harness::Submission& submission, const std::vector<path>& files) {
    if (submission.problem || submission.file.empty()) return {};
    if (!submission.lms) return "a submission of nobody without a problem";
    const LmsName& owner = *submission.lms;
    const auto readings = readings_of(submission.file, owner.system);
    std::size_t others = 0;
    bool is_owners = false;
    for (const LmsName& reading : readings) {
        const bool is_same = reading.id == owner.id && reading.student == owner.student;
        is_owners = is_owners || is_same;
        if (!is_same && (owner.system != Lms::canvas || !is_short(reading, files))) ++others;
    }
    if (!is_owners) return "a file that is given to somebody else";
    if (others > 0) return "a file that may be another student's is given to one";
    return {};
}

std::string check_download(const std::vector<std::string>& names) {
    harness::Contents contents;
    std::vector<path> files;
    for (const std::string& name : std::set<std::string>(names.begin(), names.end())) {
        const bool is_name = !name.empty() && name[0] != '.' && name.find('\0') == std::string::npos;
        if (!is_name || name.find('/') < name.size() - 1) continue;
        if (name.ends_with('/')) {
            contents.folders.push_back(name.substr(0, name.size() - 1));
            continue;
        }
        files.emplace_back(name);
        (name.ends_with(".cpp") ? contents.sources : contents.others).emplace_back(name);
    }
    const auto download = harness::from_lms_download(Names(), contents);
    if (!download) return {};
    const std::vector<harness::Submission>& submissions = download->submissions;
    for (const harness::Submission& submission : submissions) {
        if (submission.id != harness::printable(submission.id)) return "an id with control characters";
        if (std::string broken = check_submission(submission, files); !broken.empty()) return broken;
    }
    for (const path& file : contents.sources) {
        const auto is_told_of = [&](const harness::Submission& one) {
            const std::string shown = harness::printable(file.native());
            if (one.file == file || one.id == shown) return true;
            std::string told = one.problem.value_or("");
            for (const std::string& note : one.notes) told += note;
            for (const Lms system : {Lms::canvas, Lms::moodle}) {
                for (const LmsName& reading : readings_of(file, system)) {
                    // The student's own name of it may be that of no source: ".cpp".
                    const bool is_named = !harness::is_source_name(reading.file) ||
                                          told.find(harness::printable(reading.file)) != std::string::npos ||
                                          told.find("number " + reading.id) != std::string::npos;
                    if (is_named) return true;
                }
            }
            return false;
        };
        if (std::none_of(submissions.begin(), submissions.end(), is_told_of))
            return "a source that nobody is told of: " + file.native();
    }
    return {};
}

}  // namespace

std::string check_lms_name(std::string_view bytes) {
    std::vector<std::string> names;
    for (std::size_t at = 0; at <= bytes.size() && names.size() < 50;) {
        const std::size_t end = std::min(bytes.find('\n', at), bytes.size());
        names.emplace_back(bytes.substr(at, end - at));
        at = end + 1;
    }
    for (const std::string& name : names) {
        for (const auto& readings : {harness::canvas_readings(name), harness::moodle_readings(name)}) {
            if (std::string broken = check_readings(name, readings); !broken.empty()) return broken;
        }
        if (const auto read = harness::read_gradescope_name(name); read && !is_written_as(*read, name))
            return "a folder of Gradescope that is another";
        if (std::string broken = check_written(name); !broken.empty()) return broken;
        if (std::string broken = check_base_name(name); !broken.empty()) return broken;
    }
    return check_download(names);
}
