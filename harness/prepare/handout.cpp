#include "harness/prepare/handout.h"

#include <fmt/format.h>

#include <string_view>

#include "harness/prepare/handout_text.h"
#include "harness/report/page/page_template.h"
#include "harness/report/picture/picture.h"
#include "harness/text/markup.h"

namespace harness::prepare {
namespace {

/// How to write a kind of block: {0} is its text, {1} its label. `around` is the HTML element around consecutive
/// blocks.
struct Form {
    std::string_view around, html, markdown;
};

Form form_of(Block::Kind kind) {
    switch (kind) {
        case Block::Kind::title: return {"", "<h1>{0}</h1>\n", "# {0}\n\n"};
        case Block::Kind::heading: return {"", "<h2>{0}</h2>\n", "\n## {0}\n"};
        case Block::Kind::paragraph: return {"", "<p>{0}</p>\n", "\n{0}\n"};
        case Block::Kind::fact:
            return {"table", "<tr><th scope=\"row\">{1}</th><td>{0}</td></tr>\n", "- **{1}:** {0}\n"};
        case Block::Kind::picture: return {"", "<figure>\n{1}</figure>\n", "\n![{0}]({1})\n\n"};
        case Block::Kind::question: return {"", "<h3>{0}</h3>\n", "\n### {0}\n"};
        case Block::Kind::part: return {"", "<h4>{0}</h4>\n", "\n#### {0}\n"};
        case Block::Kind::item: return {"ul", "<li>{0}</li>\n", "- {0}\n"};
    }
    return {};
}

constexpr std::string_view style = R"(
@page { margin: 16mm; }
body { margin: 0 auto; max-width: 46rem; padding: 1rem; background: #fff; color: #111;
  font: 11pt/1.4 system-ui, Helvetica, Arial, "Liberation Sans", sans-serif; overflow-wrap: break-word; }
h1 { margin: 0 0 0.6rem; font-size: 1.5em; line-height: 1.2; }
h2 { margin: 1.2rem 0 0.4rem; border-bottom: 1px solid #999; font-size: 1.2em; }
h3, h4 { margin: 0.7rem 0 0.2rem; font-size: 1em; }
h4 { font-weight: normal; }
p { margin: 0.4rem 0; }
ul { margin: 0; padding-left: 1.4rem; }
table { border-collapse: collapse; }
th, td { padding: 0.1rem 1rem 0.1rem 0; text-align: left; vertical-align: top; }
figure { margin: 0.5rem 0; }
svg { display: block; max-width: 100%; height: auto; margin: 0 auto; }
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; }
  svg { max-width: 115mm; }
  h2, h3, h4 { break-after: avoid; }
  p, li, tr, figure { break-inside: avoid; }
}
)";

/// {0} is the title, {1} the Content-Security-Policy, {2} the style, {3} the text.
constexpr std::string_view page = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta http-equiv="Content-Security-Policy" content="{1}"/>
<title>{0}</title>
<style>{2}</style>
</head>
<body>
<main>
{3}</main>
</body>
</html>
)";

}  // namespace

std::string handout_picture(const reference::Assignment& assignment) {
    // The key is empty, so the picture cannot show it.
    return report::explaining_picture({assignment, {}}, nullptr, false, "raygrade-");
}

std::string handout_html(const reference::Assignment& assignment, const std::string& student) {
    std::string body;
    std::string_view open;
    const auto change_to = [&](std::string_view element) {
        if (element == open) return;
        if (!open.empty()) body += fmt::format("</{}>\n", open);
        if (!element.empty()) body += fmt::format("<{}>\n", element);
        open = element;
    };
    for (const Block& block : handout_text(assignment, student)) {
        const Form form = form_of(block.kind);
        change_to(form.around);
        body +=
            fmt::format(fmt::runtime(form.html), escape_markup(block.text),
                        block.kind == Block::Kind::picture ? handout_picture(assignment) : escape_markup(block.label));
    }
    change_to("");
    return fmt::format(page, escape_markup(assignment.title), report::security_policy({style}), style, body);
}

std::string handout_markdown(const reference::Assignment& assignment, const std::string& student,
                             const std::string& picture) {
    std::string text;
    for (const Block& block : handout_text(assignment, student)) {
        const bool is_picture = block.kind == Block::Kind::picture;
        if (is_picture && picture.empty()) continue;
        text += fmt::format(fmt::runtime(form_of(block.kind).markdown), escape_markdown(block.text),
                            is_picture ? picture : escape_markdown(block.label));
    }
    return text;
}

}  // namespace harness::prepare
