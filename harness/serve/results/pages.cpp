#include "harness/serve/results/pages.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "harness/report/page/page_template.h"
#include "harness/text/markup.h"
#include "harness/text/points.h"

namespace harness::serve {
namespace {

constexpr std::string_view nothing_else =
    "default-src 'none'; base-uri 'none'; frame-ancestors 'none'; img-src 'self'; ";

std::string page(const std::string& title, const std::string& to_top, const std::string& more_head,
                 const std::string& body) {
    return fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0}</title>\n"
        "<link rel=\"stylesheet\" href=\"{1}/style.css\">\n<link rel=\"icon\" href=\"{1}/icon.svg\">\n"
        "<script src=\"{1}/script.js\" defer></script>\n{2}</head>\n<body>\n{3}</body>\n</html>\n",
        title, to_top, more_head, body);
}

/// Empty if the sentence is empty.
std::string paragraph(const std::string& sentence, std::string_view look = "") {
    return sentence.empty() ? "" : fmt::format("<p{}>{}</p>\n", look, escape_markup(sentence));
}

std::string hours_text(std::chrono::hours hours) {
    return fmt::format("{} hour{}", hours.count(), hours.count() == 1 ? "" : "s");
}

/// A form with one field, `source`.
std::string form(const std::string& heading, const std::string& field, const std::string& button) {
    return fmt::format(
        "<form action=\"check\" method=\"post\" enctype=\"multipart/form-data\">\n<h2>{}</h2>\n{}"
        "<button type=\"submit\">{}</button>\n<p role=\"status\"></p>\n<p role=\"alert\"></p>\n</form>\n",
        heading, field, button);
}

}  // namespace

std::string not_shown(const About& about) {
    if (about.variant_points == 0) return "";
    return fmt::format("The points shown here do not include the points for other scenes (up to {}).",
                       points_text(about.variant_points));
}

std::string front_page(const About& about) {
    const std::string title = escape_markup(about.title);
    const std::string upload =
        form("Upload the file",
             "<label for=\"file\">Your ray_cast.cpp</label>\n"
             "<input type=\"file\" id=\"file\" name=\"source\" accept=\".cpp,.cc,.cxx\" required>\n",
             "Check this file");
    const std::string paste =
        form("Or paste the source",
             "<label for=\"text\">The text of your ray_cast.cpp</label>\n"
             "<textarea id=\"text\" name=\"source\" rows=\"8\" spellcheck=\"false\" autocapitalize=\"off\" "
             "autocomplete=\"off\" wrap=\"off\" required></textarea>\n",
             "Check this text");
    return page(
        "Check your ray_cast.cpp: " + title, ".", "",
        fmt::format(
            "<header>\n<p class=\"facts\">{}</p>\n<h1>Check your ray_cast.cpp</h1>\n</header>\n<main>\n"
            "<p>Your program is compiled and run exactly as it will be for grading. Each answer gets a "
            "verdict and, if it is wrong, a hint. <strong>This only checks your program and does "
            "not submit it.</strong></p>\n{}<div class=\"pair\">\n{}{}</div>\n"
            "<p class=\"facts\">One source file of at most 1 MiB. The result gets an address that nobody can guess; "
            "anyone you give the address to can read the result. The result is kept for {}, your program only until "
            "the result is ready.</p>\n</main>\n",
            title, paragraph(not_shown(about)), upload, paste, hours_text(about.keep)));
}

std::string sentence_of(const Standing& standing) {
    const auto how_long = [](const LastTook& last_took) {
        return last_took ? fmt::format("The last program took {:.0f} s.", std::ceil(last_took->count()))
                         : "Each program usually takes a few seconds.";
    };
    if (const auto* waiting = std::get_if<Waiting>(&standing)) {
        const std::string place = waiting->position == 1 ? "Your program is the next one."
                                                         : fmt::format("Your program is number {} of {} in the queue.",
                                                                       waiting->position, waiting->length);
        return place + " " + how_long(waiting->last_took);
    }
    if (const auto* grading = std::get_if<BeingGraded>(&standing))
        return "Your program is being compiled and run. " + how_long(grading->last_took);
    if (const auto* done = std::get_if<Done>(&standing)) {
        if (!done->points) return "Your program could not be checked.";
        return fmt::format("{} of {} points", points_text(*done->points), points_text(done->max_points));
    }
    if (std::holds_alternative<Lost>(standing)) {
        return "Your program could not be checked because the disk of this machine is full or failing. Please tell "
               "your instructor, and send your program again later.";
    }
    return "There is no result at this address. The address may be mistyped, or the result was deleted because it was "
           "too old.";
}

std::string waiting_page(const About& about, const std::string& result_address, const Standing& standing) {
    return page(
        "Checking: " + escape_markup(about.title), "..",
        // For browsers without script. With script, the page announces changes and reloads only when there is a result.
        "<noscript><meta http-equiv=\"refresh\" content=\"3\"></noscript>\n",
        fmt::format("<header>\n<p class=\"facts\">{0}</p>\n<h1>Your program is being checked</h1>\n</header>\n<main>\n"
                    "<p class=\"standing\" id=\"standing\" role=\"status\" data-standing=\"{1}/standing\">{2}</p>\n"
                    "<p>The result will appear on this page. You may close the page and open its address again "
                    "within {3}.</p>\n<p><a href=\"{1}\">Refresh now</a></p>\n</main>\n",
                    escape_markup(about.title), result_address, sentence_of(standing), hours_text(about.keep)));
}

std::string message_page(const About& about, const std::string& heading, const std::string& sentence,
                         const std::string& to_top) {
    const std::string safe = escape_markup(heading);
    return page(fmt::format("{}: {}", safe, escape_markup(about.title)), to_top, "",
                fmt::format("<header>\n<p class=\"facts\">{}</p>\n<h1>{}</h1>\n</header>\n<main>\n<p>{}</p>\n"
                            "<p><a href=\"{}/\">Back to the form</a></p>\n</main>\n",
                            escape_markup(about.title), safe, escape_markup(sentence), to_top));
}

// All text from students is escaped, so the first <main> and the first <body> are the page's own.
std::string as_result(const About& about, std::string student_page) {
    constexpr std::string_view main = "<main>\n";
    if (const auto at = student_page.find(main); at != std::string::npos)
        student_page.insert(at + main.size(), paragraph(not_shown(about), " class=\"note\""));
    // A page may omit its <body>.
    const auto body = student_page.find("<body");
    const auto place = body == std::string::npos ? student_page.find("<h1") : student_page.find('>', body) + 1;
    constexpr std::string_view way_back =
        "\n<nav aria-label=\"Self-check\"><a href=\"../\">Check another program</a></nav>";
    if (place != std::string::npos) student_page.insert(place, way_back);
    return student_page;
}

std::string own_policy() {
    return std::string(nothing_else) +
           "style-src 'self'; script-src 'self'; connect-src 'self'; form-action 'self'; "
           "require-trusted-types-for 'script'";
}

std::string student_policy(const std::string& student_page) {
    constexpr std::string_view begin = "<style>";
    constexpr std::string_view end = "</style>";
    std::string sources;
    const std::string_view text = student_page;
    for (std::size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at)) {
        at += begin.size();
        sources += report::hash_source(text.substr(at, text.find(end, at) - at));
    }
    return fmt::format("{}form-action 'none'; style-src{}", nothing_else, sources.empty() ? " 'none'" : sources);
}

}  // namespace harness::serve
