#include "harness/commands/options/printout.h"

#include <fmt/format.h>

#include "harness/intake/source_file.h"
#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"
#include "harness/mark/score/mark_transcript.h"
#include "harness/read/transcript.h"
#include "harness/report/text/look_first.h"
#include "harness/text/encoding.h"

namespace harness {

std::string read_printout(const std::filesystem::path& file) {
    constexpr std::size_t most_bytes = std::size_t{1} << 20U;
    BoundedFile output = read_bounded(file, most_bytes, Links::follow);
    if (!output.is_whole()) {
        throw UsageError(fmt::format("cannot read {}: {}; give a file with a program's output", file.string(),
                                     why_not_whole(output, most_bytes)));
    }
    // PowerShell's > writes UTF-16.
    const bool is_utf_16 = output.bytes.starts_with("\xff\xfe") || output.bytes.starts_with("\xfe\xff");
    return is_utf_16 ? utf8_from("UTF-16", output.bytes) : std::move(output.bytes);
}

Score mark_printout(const std::filesystem::path& file, const std::string& output, const reference::AnswerKey& key,
                    const reference::Assignment& assignment) {
    const char* way_out = "; give a file with the program's output: ./ray_cast > output.txt";
    if (is_source_name(file.filename().string()))
        throw UsageError(fmt::format("{} is a program{}", file.string(), way_out));
    Score marked = score(read_transcript(output, last_question(assignment.questions)), key, assignment);
    if (report::holds_no_answer(marked))
        throw UsageError(fmt::format("{} has no answer to any question{}", file.string(), way_out));
    return marked;
}

}  // namespace harness
