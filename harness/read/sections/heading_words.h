// The words and numbers of headings, and where a heading ends.
#pragma once

#include <cstddef>
#include <string_view>

namespace harness {

inline constexpr std::size_t longest_heading = 200;  ///< bytes of a line

/// What may stand before the word: the course and the assignment, or what the program does with the question.
inline constexpr const char* question_words =
    R"((?i:(?:[a-z]{2,4}\s?\d{3}\W+)?(?:assignment\s\d|a\d|hw\s?\d|(?:sheet|lab|blatt|(?:\x{FC}|ue)bungsblatt|serie|hoja|feuille)\s\d{1,2})[\s,:\-]*|(?:my )?(?:answers?|solutions?|results?|outputs?) (?:to|for|of) |section[\s:]+|antwort (?:auf|zu) |(?:this|here) is |(?:now )?(?:computing|calculating|running|solving|answering|evaluating|doing|working on|begin|beginning|start|starting)(?: of)? |now |the )?(?i:§|questions?|quest|ques|qn?|exercises?|exer|exc|ex|exo|problems?|prob|tasks?|aufgabe|aufg|(?:[\x{DC}\x{FC}\x{FFFD}]|ue)bung|frage|vraag|opgave|pregunta|ejercicio|domanda|esercizio|pergunta))";

/// A number of one to ten in words, as a pattern with one group.
inline constexpr const char* number_words =
    R"((?i:(one|two|three|four|five|six|seven|eight|nine|ten|eins|zwei|drei|vier|f(?:\x{FC}|\x{DC}|ue)nf|sechs|sieben|acht|neun|zehn|uno|dos|tres|cuatro|cinco|seis|siete|ocho|nueve|diez)))";

/// The value of one of the number_words; 0 for another word.
int spelled_number(std::string_view word);

/// Where a heading of `length` bytes ends. A '-' directly before a number belongs to that number.
std::size_t end_of(std::string_view start, std::size_t length);

}  // namespace harness
