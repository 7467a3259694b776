// A text from a submission, shown on a page with line numbers: what a program printed, or its source.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "harness/record/graded.h"
#include "harness/report/compile_error/compiler_messages.h"

namespace harness::report {

/// What a page says of a line, behind its text.
struct LineNote {
    std::string text;  ///< "6.t right"; empty if the line is only coloured
    std::string kind;  ///< the HTML class that colours it: a verdict, "error" or "warning"
};

/// By line, from 1.
using LineNotes = std::map<int, std::vector<LineNote>>;

/// The answers that were read from each line, with their verdicts. Holds nothing of the key.
LineNotes notes_of_answers(const Score& score);

/// The compiler's messages by line of the source.
LineNotes notes_of_compiler(const std::vector<CompilerMessage>& messages);

/// Whether the program printed more than is kept.
bool is_printout_too_long(const Graded& graded);

inline constexpr std::string_view too_long_sentence =
    "The output was too long to keep. At most its first 200 lines are shown.";

/// The output, or of one that is too long its beginning.
inline const std::string& shown_printout(const Graded& graded) {
    const ExecutionRecord& execution = graded.execution;
    return execution.printout.empty() ? execution.printout_beginning : execution.printout;
}

/// The numbers after "line " in a sentence of raygrade's, in their order.
std::vector<int> lines_named(std::string_view sentence);

/// How much of a text is shown. A line is cut too, at 500 bytes.
struct ListingBounds {
    std::size_t lines = 1000;
    std::size_t bytes = std::size_t{64} << 10U;
};

/// A line of a source, from 1, as a compiler counts them, without the blanks around it; at most 500 bytes. Empty if
/// there is no such line.
std::string source_line(std::string_view source, int line);

class Listing {
  public:
    /// `text` is shown as it is, whatever its bytes, and need not outlive the listing. `prefix` makes the lines' ids:
    /// it is unique on the page. `source` counts lines as a compiler does, an output as the reader does
    /// (read_lines.h).
    static Listing of_printout(std::string_view text, const LineNotes& notes, const std::string& prefix,
                               const ListingBounds& bounds = {});
    static Listing of_source(std::string_view text, const LineNotes& notes, const std::string& prefix,
                             const ListingBounds& bounds = {});
    /// Nothing to show, and no line to link to.
    Listing() = default;

    bool empty() const { return html_.empty(); }

    /// A <pre> of one <span> per line, named `label`, and a sentence if the text is cut. Well-formed as XML.
    std::string html(std::string_view label) const;

    /// Whether a link can lead to this line, as it is shown.
    bool has_anchor(int line) const;

    /// "#o12".
    std::string address_of(int line) const;

    /// A sentence of raygrade's as HTML, in which each "line 12" is a link to that line if it has an anchor. The rest
    /// is escaped.
    std::string with_links(std::string_view sentence) const;

  private:
    Listing(const std::vector<std::string_view>& lines, bool is_whole, const LineNotes& notes,
            const std::string& prefix, const ListingBounds& bounds);

    std::string prefix_;
    std::string html_;  ///< the lines
    std::string cut_;   ///< a sentence; empty if the text is whole
    int last_line_ = 0;
};

}  // namespace harness::report
