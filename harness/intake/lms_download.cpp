#include "harness/intake/lms_download.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "harness/intake/archive.h"
#include "harness/intake/hand_in.h"
#include "harness/intake/lms/gradescope_metadata.h"
#include "harness/intake/lms/lms_name.h"
#include "harness/text/encoding.h"
#include "harness/text/printable.h"

namespace harness {
namespace {

using std::filesystem::path;

std::vector<LmsName> the_only(const std::optional<LmsName>& reading) {
    return reading ? std::vector{*reading} : std::vector<LmsName>();
}

std::vector<LmsName> readings_of(Lms lms, const path& file, bool is_folder) {
    const std::string name = file.filename();
    switch (lms) {
        case Lms::canvas: return is_folder ? std::vector<LmsName>() : canvas_readings(name);
        case Lms::moodle: {
            auto readings = moodle_readings(name);
            // Older versions of Moodle end a folder's name with '_'; in the flat form the file's name follows.
            std::erase_if(readings, [&](const LmsName& read) { return is_folder != read.file.empty(); });
            return readings;
        }
        case Lms::gradescope: return the_only(is_folder ? read_gradescope_name(name) : std::nullopt);
        case Lms::brightspace: {
            const auto read = read_brightspace_name(name);
            return the_only(read && is_folder == read->file.empty() ? read : std::nullopt);
        }
        case Lms::blackboard: return the_only(is_folder ? std::nullopt : read_blackboard_name(name));
    }
    return {};
}

std::vector<path> files_of(const Contents& contents) {
    std::vector<path> files;
    for (const auto* some : {&contents.sources, &contents.headers, &contents.archives, &contents.others}) {
        files.insert(files.end(), some->begin(), some->end());
    }
    return files;
}

bool is_gradescope_metadata(const path& file) {
    return file.filename() == gradescope_metadata_name;
}

/// The files and folders without a name of this LMS, except its metadata file.
Contents strangers_of(Lms lms, const Contents& contents) {
    Contents strangers;
    const auto pick = [&](const std::vector<path>& from, std::vector<path>& to, bool are_folders) {
        std::copy_if(from.begin(), from.end(), std::back_inserter(to), [&](const path& file) {
            return !is_gradescope_metadata(file) && readings_of(lms, file, are_folders).empty();
        });
    };
    pick(contents.sources, strangers.sources, false);
    pick(contents.headers, strangers.headers, false);
    pick(contents.archives, strangers.archives, false);
    pick(contents.others, strangers.others, false);
    pick(contents.folders, strangers.folders, true);
    strangers.linked = contents.linked;
    return strangers;
}

std::size_t count_of(const Contents& contents) {
    return files_of(contents).size() + contents.folders.size() + contents.linked.size();
}

/// One stray file must not hide a class, and one file that looks like a download's does not make a download.
bool is_of(Lms lms, const Contents& contents) {
    return 2 * count_of(strangers_of(lms, contents)) < count_of(contents);
}

std::optional<Lms> lms_of(const Contents& contents) {
    for (const Lms lms : {Lms::brightspace, Lms::blackboard, Lms::canvas, Lms::moodle, Lms::gradescope}) {
        if (is_of(lms, contents)) return lms;
    }
    return std::nullopt;
}

/// One student of a download.
struct Student {
    LmsName name;                              ///< of the first file or folder; late if any of them is
    std::map<std::string, HandIn> attempts{};  ///< by LmsName::handed_in; the last counts
    std::vector<std::string> notes{};
    std::string refusal{};  ///< why nothing of the student was read; empty if it was
};

void add_file(HandIn& hand_in, const LmsName& name, const path& file) {
    if (name.is_file && is_source_name(name.file)) {
        hand_in.sources.push_back({file, name.file, name.attachment});
    } else if (name.is_file && is_archive_name(name.file)) {
        hand_in.archives.push_back({file, name.file, name.attachment});
    } else {
        hand_in.others.push_back(name.file);
    }
}

/// A file or folder of a download, and its owner.
struct Owned {
    path file;
    bool is_folder = false;
    std::vector<LmsName> readings;  ///< several if its name is ambiguous
};

/// Canvas gives the files of one assignment numbers of about the same size. So a number with far fewer digits than
/// those of unambiguous files belongs to the student's own file name: "doejane_4711_70815_6_2.cpp".
void leave_out_short_attachments(std::vector<Owned>& owned) {
    std::size_t fewest = 0;
    for (const Owned& one : owned) {
        const std::size_t digits = one.readings.front().attachment.size();
        if (one.readings.size() == 1 && digits > 0) fewest = fewest == 0 ? digits : std::min(fewest, digits);
    }
    for (Owned& one : owned) {
        const auto is_short = [&](const LmsName& read) { return read.is_file && read.attachment.size() + 1 < fewest; };
        if (one.readings.size() == most_readings) continue;  // the true one may not be among them
        if (one.readings.size() > 1 && !std::all_of(one.readings.begin(), one.readings.end(), is_short))
            std::erase_if(one.readings, is_short);
    }
}

std::vector<Owned> owned_files(Lms lms, const Contents& contents) {
    std::vector<Owned> owned;
    const auto add = [&](const path& file, bool is_folder) {
        auto readings = readings_of(lms, file, is_folder);
        if (!readings.empty()) owned.push_back({file, is_folder, std::move(readings)});
    };
    for (const path& file : files_of(contents)) add(file, false);
    for (const path& folder : contents.folders) add(folder, true);
    if (lms == Lms::canvas) leave_out_short_attachments(owned);
    return owned;
}

std::string reading_text(const LmsName& name) {
    const std::string who = name.student.empty() ? "" : " (" + in_quotes(name.student) + ")";
    return "number " + name.id + who + " with the file " + in_quotes(name.file);
}

/// A submission that may belong to several students. Nobody gets its marks.
Submission of_unclear_owner(const Owned& owned) {
    return with_problem(printable(owned.file.filename().native()),
                        "Its name has several meanings: " + reading_text(owned.readings[0]) + ", or " +
                            reading_text(owned.readings[1]) +
                            ". Find out who handed it in, and put it into a folder with that name.");
}

/// The students of a download by number and name, and the files whose owner is not certain.
struct Download {
    std::map<std::pair<std::string, std::string>, Student> students;
    std::vector<Submission> unclear;
};

Download students_of(Lms lms, const FileTree& tree, const Contents& contents) {
    Download download;
    for (const Owned& owned : owned_files(lms, contents)) {
        if (owned.readings.size() > 1) {
            download.unclear.push_back(of_unclear_owner(owned));
            if (const std::string why = tree.refusal(owned.file); !why.empty())
                download.unclear.back().notes.push_back(why);
            continue;
        }
        LmsName name = owned.readings.front();
        name.student = composed_name(name.student);
        Student& student = download.students.try_emplace({name.id, name.student}, Student{name}).first->second;
        if (name.late == true) student.name.late = true;
        if (std::string why = tree.refusal(owned.file); !why.empty()) student.refusal = std::move(why);
        HandIn& hand_in = student.attempts[name.handed_in];
        if (!owned.is_folder) {
            add_file(hand_in, name, owned.file);
        } else if (name.is_file) {
            hand_in.add_all_in(tree, owned.file);
        } else {
            hand_in.others.push_back(owned.file.filename());
        }
    }
    return download;
}

/// Reads the export's metadata file; a problem if it is missing or can't be read.
GradescopeMetadata metadata_of(const FileTree& tree, const Contents& contents) {
    const auto file = std::find_if(contents.others.begin(), contents.others.end(), is_gradescope_metadata);
    if (file == contents.others.end()) return {{}, {}, {}, "is missing"};
    const BoundedFile read = tree.read(*file, largest_gradescope_metadata);
    if (!read.is_whole()) return {{}, {}, {}, "cannot be read: " + why_not_whole(read, largest_gradescope_metadata)};
    return read_gradescope_metadata(read.bytes);
}

/// Gives a Gradescope submission the names of its submitters, or says why it has none.
void give_names(Student& student, const GradescopeMetadata& metadata) {
    const std::string folder = "submission_" + student.name.id;
    if (const auto when = metadata.created_at.find(folder); when != metadata.created_at.end())
        student.name.handed_in = when->second;
    const auto found = metadata.submitters.find(folder);
    if (found != metadata.submitters.end()) {
        student.name.submitters = found->second;
        student.name.student = names_of(found->second);
        return;
    }
    const auto problem = metadata.problems.find(folder);
    const std::string why = metadata.problem                     ? *metadata.problem
                            : problem != metadata.problems.end() ? problem->second
                                                                 : "does not mention it";
    student.notes.push_back("Named by its folder instead of its student, because submission_metadata.yml " + why +
                            ". Export the submissions from Gradescope again.");
}

Submission from_student(const FileTree& tree, const Student& student, const std::string& id) {
    const auto& [when, last] = *student.attempts.rbegin();
    Submission submission = student.refusal.empty() ? take(tree, last, id) : with_problem(id, student.refusal);
    if (student.attempts.size() > 1) {
        submission.notes.push_back(
            fmt::format("Handed in {} times; the last one, of {}, counts.", student.attempts.size(), when));
    }
    if (student.name.late == true) submission.notes.insert(submission.notes.begin(), "Marked late in the download.");
    submission.notes.insert(submission.notes.end(), student.notes.begin(), student.notes.end());
    submission.lms = student.name;
    if (!when.empty()) submission.lms->handed_in = when;
    return submission;
}

std::string_view name_of(Lms lms) {
    switch (lms) {
        case Lms::canvas: return "Canvas";
        case Lms::moodle: return "Moodle";
        case Lms::gradescope: return "Gradescope";
        case Lms::brightspace: return "Brightspace";
        case Lms::blackboard: return "Blackboard";
    }
    return "";
}

}  // namespace

std::size_t count_lms_names(const Contents& contents) {
    const auto lms = lms_of(contents);
    return lms ? count_of(contents) - count_of(strangers_of(*lms, contents)) : 0;
}

void add_strangers(const Contents& strangers, const std::string& why, LmsDownload& download) {
    for (const auto* some : {&strangers.sources, &strangers.archives, &strangers.folders, &strangers.linked}) {
        for (const path& file : *some) {
            download.submissions.push_back(
                with_problem(printable(file.filename().native()),
                             fmt::format("{} {}, so its student is unknown. Put it into a folder with the student's "
                                         "name and grade that, or move it away.",
                                         in_quotes(file.filename()), why)));
        }
    }
    for (const auto* some : {&strangers.headers, &strangers.others})
        download.left_out.insert(download.left_out.end(), some->begin(), some->end());
}

std::optional<LmsDownload> from_lms_download(const FileTree& tree, const Contents& contents) {
    const auto lms = lms_of(contents);
    if (!lms) return std::nullopt;
    auto [students, submissions] = students_of(*lms, tree, contents);
    if (*lms == Lms::gradescope) {
        const GradescopeMetadata metadata = metadata_of(tree, contents);
        for (auto& [key, student] : students) give_names(student, metadata);
    }
    std::map<std::string, int> named, numbered;
    for (const auto& [key, student] : students) {
        ++named[student.name.student];
        ++numbered[key.first];
    }
    for (const auto& [key, student] : students) {
        const std::string& number = key.first;
        const std::string& name = student.name.student;
        std::string id = !name.empty() ? name : *lms == Lms::gradescope ? "submission_" + number : number;
        if (!name.empty() && named[name] > 1) id += '_' + number;
        if (numbered[number] > 1) {
            submissions.push_back(with_problem(
                printable(id),
                "Files with different names have the number " + number +
                    ". Find out whose number it is, and put that student's files into a separate folder."));
        } else {
            submissions.push_back(from_student(tree, student, printable(id)));
        }
    }
    LmsDownload download{std::move(submissions), {}};
    add_strangers(strangers_of(*lms, contents), fmt::format("is not named like a submission from {}", name_of(*lms)),
                  download);
    return download;
}

}  // namespace harness
