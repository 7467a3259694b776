// Reads the zip back with python3's zipfile, and assigns the pages to students by the rules of Canvas and Moodle.
#include "harness/report/exchange/feedback_zip.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <ctime>
#include <sstream>

#include "tests/given/cases.h"
#include "tests/given/report/graded_samples.h"
#include "tests/given/report/told_by.h"

namespace harness::report {
namespace {

using namespace report_samples;
using testing::ElementsAre;
using testing::IsEmpty;

/// A submission whose page says "Page of <mark>."
Graded handed_in(const std::string& mark, const std::optional<LmsName>& lms) {
    static const Graded sample = graded("", output_with_a_mistake());
    Graded one = sample;
    one.submission.id = mark;
    one.submission.file = "ray_cast.cpp";
    one.submission.lms = lms;
    one.execution.explanation = "Page of " + mark + ".";
    return one;
}

Graded in_canvas(const std::string& mark, const std::string& file) {
    const auto name = read_canvas_name(file);
    EXPECT_TRUE(name) << file;
    Graded one = handed_in(mark, name);
    one.submission.file = "class.zip/" + file;
    return one;
}

Graded in_moodle(const std::string& mark, const std::string& folder) {
    const auto name = read_moodle_name(folder);
    EXPECT_TRUE(name) << folder;
    return handed_in(mark, name);
}

std::string zip_of(const std::vector<Graded>& graded) {
    std::ostringstream bytes;
    write_feedback_zip(bytes, graded, marking());
    return std::move(bytes).str();
}

/// Opens the zip as `z`, and checks that it is complete and that no entry leads outside. page(n) names the student
/// whose page the entry n is.
constexpr const char* open_zip = R"(
import re
z = zipfile.ZipFile(sys.argv[1])
assert z.testzip() is None
for n in z.namelist():
    parts = n.split('/')
    assert all(p not in ('', '.', '..') and len(p.encode()) < 256 and not p.startswith(('.', '~')) for p in parts), n
    assert not re.search(r'[\x00-\x1f\x7f\\:*?"<>|]', n), n
assert len(set(z.namelist())) == len(z.namelist())
page = lambda n: re.search(r'Page of ([^.<]*)\.', z.read(n).decode()).group(1)
# instructure/canvas-lms, infer_comment_context_from_filename: (user, attachment)
def canvas(n):
    fields = n.split('/')[-1].split('_')
    numbers = [f for f in fields if re.fullmatch('[0-9]+', f)][:2]
    return tuple(numbers) if not fields[-1].startswith('link') and not n.startswith('._') else None
# moodle, importziplib.php: the participant
def moodle(n):
    for part in n.split('/'):
        info = part.split('_', 4)
        if len(info) >= 4 and re.fullmatch('[0-9]+', info[1]) and info[2:4] == ['assignsubmission', 'file']:
            return info[1]
)";

TEST(FeedbackZip, GoesBackToItsStudentInCanvas) {
    const std::string zip = zip_of(
        {in_canvas("jane", "doejane_1001_5001_ray_cast.cpp"), in_canvas("john", "doejohn_LATE_1002_5002_main_7_8.cpp"),
         in_canvas("jan", "łukaszewiczján_1003_5003_ü.cpp"), in_canvas("anonymous", "anon_aB3x9_5004_ray_cast.cpp")});
    EXPECT_EQ(python(std::string(open_zip) + "for n in z.namelist(): print(n, page(n), canvas(n))\n", zip),
              "doejane_1001_5001_feedback.html jane ('1001', '5001')\n"
              "doejohn_LATE_1002_5002_feedback.html john ('1002', '5002')\n"
              "łukaszewiczján_1003_5003_feedback.html jan ('1003', '5003')\n"
              "anon_aB3x9_5004_feedback.html anonymous ('5004',)\n");
}

TEST(FeedbackZip, GoesBackToItsStudentForAnyName) {
    // A different version of the system, or a person who renamed the file, may write such a name.
    const auto called = [](Lms system, const std::string& name) {
        LmsName lms;
        lms.system = system;
        lms.student = name;
        lms.attachment = system == Lms::canvas ? "5" : "";
        return lms;
    };
    std::vector<Graded> class_;
    for (const Lms system : {Lms::canvas, Lms::moodle}) {
        int number = 100;
        for (const std::string name : {"group_2_of_3", "77", "_88_", "X_5_assignsubmission_file", "../../etc", "a/b",
                                       "a\\b", ".hidden", "~x", "._mac", "", "Jane \x1b[31m\xff", "link", "LATE_9",
                                       "\xe2\x80\xae"
                                       "gpj.exe"}) {
            LmsName lms = called(system, name);
            lms.id = std::to_string(++number);
            class_.push_back(handed_in((system == Lms::canvas ? "c" : "m") + lms.id, lms));
        }
        LmsName longest = called(system, std::string(99, 'x') + "ééééé" + std::string(300, 'y'));
        longest.id = std::to_string(++number);
        class_.push_back(handed_in((system == Lms::canvas ? "c" : "m") + longest.id, longest));
    }
    EXPECT_EQ(python(std::string(open_zip) + "for n in z.namelist():\n"
                                             "    who = 'm' + moodle(n) if '/' in n else 'c' + canvas(n)[0]\n"
                                             "    assert page(n) == who, (n, page(n), who)\n"
                                             "    assert '/' in n or canvas(n)[1] == '5', n\n"
                                             "print(len(z.namelist()))\n",
                     zip_of(class_)),
              "32\n");
}

TEST(FeedbackZip, GoesBackToItsStudentInMoodle) {
    const std::string zip = zip_of({in_moodle("jane", "Jane Doe_12_assignsubmission_file_"),
                                    in_moodle("zan", "Żan Łukasz_13_assignsubmission_file"),
                                    in_moodle("blind", "Participant_14_assignsubmission_file"),
                                    in_moodle("flat", "Rick Roe_15_assignsubmission_file_ray_cast.cpp")});
    EXPECT_EQ(python(std::string(open_zip) + "for n in z.namelist(): print(n, page(n), moodle(n))\n", zip),
              "Jane Doe_12_assignsubmission_file/feedback.html jane 12\n"
              "Żan Łukasz_13_assignsubmission_file/feedback.html zan 13\n"
              "Participant_14_assignsubmission_file/feedback.html blind 14\n"
              "Rick Roe_15_assignsubmission_file/feedback.html flat 15\n");
}

TEST(FeedbackZip, UsesTheNumbersOfTheGradedFile) {
    Graded again = in_canvas("jane", "doejane_1001_5001_notes.txt");
    again.submission.file = "class.zip/doejane_1001_5009_ray_cast-1.cpp";
    EXPECT_EQ(way_back(again.submission), "doejane_1001_5009_feedback.html");
    again.submission.file = "class.zip/doejane_1001_5001_all.zip/roerick_7_8_ray_cast.cpp";
    EXPECT_EQ(way_back(again.submission), "doejane_1001_5001_feedback.html") << "a packed file may be called anything";
}

TEST(FeedbackZip, LeavesOutPagesOfUnknownStudents) {
    std::ostringstream bytes;
    const FeedbackZip zip = write_feedback_zip(
        bytes,
        {in_canvas("twin", "doejane_1001_5001_ray_cast.cpp"), in_canvas("other twin", "roerick_1001_5002_ray_cast.cpp"),
         in_canvas("text", "poepat_1003_text.html"), in_moodle("1001", "Jane Doe_1001_assignsubmission_file"),
         handed_in("gradescope", read_gradescope_name("submission_1001")), handed_in("folder", std::nullopt)},
        marking());
    EXPECT_EQ(zip.pages, 1U);
    EXPECT_THAT(zip.left_out, ElementsAre("twin: another submission has the same number, 1001",
                                          "other twin: another submission has the same number, 1001",
                                          "text: Canvas has no file from this student, so the page can't be returned"));
    EXPECT_EQ(python(std::string(open_zip) + "print([page(n) for n in z.namelist()])\n", bytes.str()), "['1001']\n");
}

TEST(FeedbackZip, IsOnlyForClassesOfAnLms) {
    EXPECT_FALSE(is_from_lms(
        {handed_in("folder", std::nullopt), handed_in("gradescope", read_gradescope_name("submission_1"))}));
    EXPECT_TRUE(is_from_lms({handed_in("folder", std::nullopt), in_canvas("x", "x_1_text.html")}));
}

TEST(FeedbackZip, CanHoldThousandsOfPages) {
    std::vector<Graded> class_;
    Graded one = not_graded("x");
    const std::string count = std::to_string(cases(2'000));
    for (std::uint64_t i = 0; i < cases(2'000); ++i) {
        one.submission.lms =
            read_moodle_name("Student " + std::to_string(i) + "_" + std::to_string(i + 1) + "_assignsubmission_file");
        one.submission.id = std::to_string(i);
        class_.push_back(one);
    }
    EXPECT_EQ(python(std::string(open_zip) + "print(len(z.namelist()), z.namelist()[-1])\n", zip_of(class_)),
              count + " Student " + std::to_string(cases(2'000) - 1) + "_" + count +
                  "_assignsubmission_file/feedback.html\n");
}

}  // namespace
}  // namespace harness::report
