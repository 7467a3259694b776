// A text from a submission, shown on a page with line numbers: a program's output or its source.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "harness/record/graded.h"
#include "harness/report/compile_error/compiler_messages.h"

namespace harness::report {

/// A note that a page shows after the text of a line.
struct LineNote {
    std::string text;  ///< "6.t right"; empty if the line is only colored
    std::string kind;  ///< the HTML class that colors it: a verdict, "error" or "warning"
};

/// By line, from 1.
using LineNotes = std::map<int, std::vector<LineNote>>;

/// The answers that were read from each line, with their verdicts. Reveals nothing from the key.
LineNotes notes_of_answers(const Score& score);

/// The compiler's messages by line of the source.
LineNotes notes_of_compiler(const std::vector<CompilerMessage>& messages);

/// Whether the output was too long to keep.
bool is_printout_too_long(const Graded& graded);

inline constexpr std::string_view too_long_sentence =
    "The output was too long to keep. At most its first 200 lines are shown.";

/// The output, or only its beginning if it was too long to keep.
inline const std::string& shown_printout(const Graded& graded) {
    const ExecutionRecord& execution = graded.execution;
    return execution.printout.empty() ? execution.printout_beginning : execution.printout;
}

/// The numbers after "line " in one of raygrade's sentences, in order.
std::vector<int> lines_named(std::string_view sentence);

/// How much of a text is shown. A line is cut too, at 500 bytes.
struct ListingBounds {
    std::size_t lines = 1000;
    std::size_t bytes = std::size_t{64} << 10U;
};

/// The source line with this number, counted from 1 as a compiler does, without surrounding blanks; at most 500 bytes.
/// Empty if there is no such line.
std::string source_line(std::string_view source, int line);

class Listing {
  public:
    /// Shows `text` unchanged; it may contain any bytes and need not outlive the listing. The lines' ids begin with
    /// `prefix`, which must be unique on the page. of_source counts lines as a compiler does, of_printout as the reader
    /// does (read_lines.h).
    static Listing of_printout(std::string_view text, const LineNotes& notes, const std::string& prefix,
                               const ListingBounds& bounds = {});
    static Listing of_source(std::string_view text, const LineNotes& notes, const std::string& prefix,
                             const ListingBounds& bounds = {});
    /// An empty listing, with no lines to link to.
    Listing() = default;

    bool empty() const { return html_.empty(); }

    /// A <pre> with one <span> per line, named `label`, and a sentence if the text is cut. Well-formed XML.
    std::string html(std::string_view label) const;

    /// Whether the page shows this line, so that a link can lead to it.
    bool has_anchor(int line) const;

    /// "#o12".
    std::string address_of(int line) const;

    /// One of raygrade's sentences as HTML. Each "line 12" in it becomes a link if that line has an anchor. The rest is
    /// escaped.
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
