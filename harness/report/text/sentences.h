// The sentences that several reports share.
#pragma once

#include <string>
#include <vector>

#include "harness/mark/score/doubts_text.h"
#include "harness/record/graded.h"
#include "reference/toml/assignment.h"

namespace harness::report {

/// Describes an answer of this shape: "a vector of three numbers".
std::string expected_shape(reference::Shape shape);

/// The item's name, with the part if its question has parts: "t", "b) t".
std::string name_in_question(const reference::ItemSpec& spec);

/// "question 6 (t)", "question 10 (which object is hit first)".
std::string item_in_words(int question, const reference::ItemSpec& spec);

/// ItemScore::reread for the student, without the account name.
std::string told_reread(const Graded& graded, const ItemScore& item);

/// Whether the program was cut short. If so, it might have printed the missing answers later.
bool was_cut_short(Outcome outcome);

/// Sentences on why an item lost points or was accepted in another form, as far as `feedback` allows; empty if it is
/// simply right.
std::string item_sentence(const ItemScore& item, Outcome outcome,
                          reference::Feedback feedback = reference::Feedback::mistake);

/// The words before ItemScore::printed: "you printed", or "read as b =" where that may be a misreading.
std::string before_printed(const ItemScore& item);
/// With a capital letter at its start.
std::string capitalized(std::string sentence);

/// How the item was found, for an instructor: the note of a person or an experiment, or that no label names the item.
/// Empty if the item was found by its label or is missing.
std::string how_found(const ItemScore& item);

/// For an instructor: "Comment on question 6, t", "Accepted: Doubtful readings".
std::string decision_in_words(const Decision& decision);

/// The mistake's name, as far as `feedback` allows; empty if none is known.
std::string told_diagnosis(const ItemScore& item, reference::Feedback feedback);

/// One sentence about all missing answers: "Not found in the output: question 8 and question 6 (t, hit). …"; empty if
/// none is missing or nothing was printed.
std::string missing_sentence(const Graded& graded);

/// One sentence about all answers that are right in another form, with the reasons; empty if there are none.
std::string accepted_sentence(const Score& score);

/// The points for other scenes: "Other scenes: 4 of 5 points." Precondition: the rubric gives points for them.
std::string scenes_sentence(const Graded& graded);

/// Says that the rubric's cap on follow-through, in points, reduced the points.
std::string cap_sentence(double cap);

/// Tells a student how to find the line where the program crashes. Empty if it did not crash or if there are sanitizer
/// findings.
std::string crash_advice(const Graded& graded);

/// Tells the student why a submission has no marks. Hides the folders of the instructor's machine and failures on it;
/// the class table shows both to the instructor. May contain the student's own file names.
std::string reason_for_student(const Submission& submission);

/// The instructor's overrides, corrections and comments: "Your instructor gave 4 points for question 8: copied".
std::vector<std::string> instructor_sentences(const Graded& graded);
/// The evidence for a flag. Students see less than instructors where the evidence would reveal an answer.
std::string evidence_text(const Graded& graded, const Flag& flag, Audience audience);

}  // namespace harness::report
