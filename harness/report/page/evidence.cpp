#include "harness/report/page/evidence.h"

#include <fmt/format.h>

#include "harness/record/concern_titles.h"
#include "harness/record/concerns.h"
#include "harness/record/hard_scenes_sentences.h"
#include "harness/record/variants_sentences.h"
#include "harness/report/compile_error/compiler_hints.h"
#include "harness/report/compile_error/compiler_messages.h"
#include "harness/report/page/templates.h"
#include "harness/report/text/sentences.h"

namespace harness::report {
namespace {

PageData beginnings_of(const std::vector<std::string>& texts, std::size_t most_bytes) {
    PageData list(PageData::type::list);
    for (const std::string& text : texts) list.push_back(beginning_of(text, most_bytes));
    return list;
}

}  // namespace

std::string Evidence::compiler(const Graded& graded, const Listing& source) const {
    const std::string& diagnostics = graded.execution.build.diagnostics;
    if (diagnostics.empty()) return "";
    PageData data;
    data["level"] = std::string(heading);
    data["only_warnings"] = graded.execution.outcome != Outcome::compile_error;
    PageData hints(PageData::type::list);
    for (const std::string& hint : compiler_hints(graded)) hints.push_back(source.with_links(hint));
    data["has_hints"] = hints.is_non_empty_list();
    data["hints"] = std::move(hints);
    PageData lines = list_of(compiler_messages(diagnostics), [&](PageData& line, const CompilerMessage& message) {
        line["where"] = source.with_links(fmt::format("Line {}", message.line));
        set_text(line, "source", source_line(graded.submission.source, message.line));
        line["kind"] = message.kind;
        line["text"] = message.text;
    });
    data["has_lines"] = lines.is_non_empty_list();
    data["lines"] = std::move(lines);
    data["diagnostics"] = beginning_of(diagnostics, most_bytes);
    return PageTemplate(templates::messages_mustache).fill_in(data);
}

std::string Evidence::others(const Graded& graded, const Listing& printout, const Listing& source) const {
    const std::vector<std::string>& notes = graded.submission.notes;
    const std::vector<Flag> open = audience == Audience::student ? flags_for_student(graded) : open_flags(graded);
    const bool none =
        open.empty() && graded.execution.sanitizer.empty() && notes.empty() && graded.execution.run.errors.empty();
    if (none && !graded.findings.variants && !graded.findings.hard_scenes) return "";
    PageData data;
    data["level"] = std::string(heading);
    data["flags"] = list_of(open, [&](PageData& page_data, const Flag& flag) {
        page_data["flag"] = title_of(flag.kind).sentence;
        const Listing& named = flag.kind == "hard_coded" ? source : printout;
        page_data["proof"] = named.with_links(beginning_of(evidence_text(graded, flag, audience), most_bytes));
    });
    data["has_flags"] = !open.empty();
    data["has_findings"] = !graded.execution.sanitizer.empty();
    data["findings"] = beginnings_of(graded.execution.sanitizer, most_bytes);
    std::vector<std::string> variants;
    if (graded.findings.variants) variants = variants_sentences(*graded.findings.variants, audience);
    data["scenes_worth"] = graded.score.variants ? scenes_sentence(graded) : "This costs no points.";
    data["has_variants"] = !variants.empty();
    data["variants"] = beginnings_of(variants, most_bytes);
    std::vector<std::string> hard_scenes;
    if (graded.findings.hard_scenes) hard_scenes = hard_scenes_sentences(*graded.findings.hard_scenes);
    data["has_hard_scenes"] = !hard_scenes.empty();
    data["hard_scenes"] = beginnings_of(hard_scenes, most_bytes);
    data["has_notes"] = !notes.empty();
    data["notes"] = beginnings_of(notes, most_bytes);
    set_text(data, "errors", beginning_of(graded.execution.run.errors, most_bytes));
    return PageTemplate(templates::evidence_mustache).fill_in(data);
}

}  // namespace harness::report
