#include "harness/review/site.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sodium.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "harness/class_run/corrections.h"
#include "harness/machine/hash.h"
#include "harness/record/concerns.h"
#include "harness/report/page/templates.h"
#include "harness/review/past.h"
#include "harness/review/templates.h"
#include "harness/serve/request/host_names.h"

namespace harness::review {
namespace {

using serve::Head;
using serve::Method;
using serve::Response;
using Kind = Decision::Kind;

constexpr std::size_t state_digits = 32;

Response page(int status, std::string html) {
    return {status, "text/html; charset=utf-8", std::move(html), {{"Content-Security-Policy", page_policy()}}};
}

Response plain(int status, const std::string& sentence) {
    return {status, "text/plain; charset=utf-8", sentence + "\n", {}};
}

Response redirect(const std::string& path) {
    return {303, "text/plain; charset=utf-8", "", {{"Location", path}}};
}

std::optional<std::int64_t> number_in(std::string_view text) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1) return std::nullopt;
    return number;
}

bool is_post_path(const std::string& path) {
    return path == "/decide" || path == "/apply" || path == "/undo" || path == "/take-back";
}

std::optional<Response> asset(const std::string& path) {
    if (path == "/style.css") {
        return Response{200,
                        "text/css; charset=utf-8",
                        std::string(report::templates::page_css) + std::string(templates::review_css),
                        {}};
    }
    if (path == "/script.js")
        return Response{200, "text/javascript; charset=utf-8", std::string(templates::review_js), {}};
    if (path == "/icon.svg") return Response{200, "image/svg+xml", std::string(templates::icon_svg), {}};
    return {};
}

/// Throws UsageError.
Wish wish_in(const FormFields& form) {
    Wish wish;
    const std::string kind = form.value("kind");
    bool known = false;
    for (const Kind each : {Kind::accepted, Kind::comment, Kind::points, Kind::reading}) {
        if (to_string(each) != kind) continue;
        wish.kind = each;
        known = true;
    }
    if (!known) throw UsageError("This form is unknown. Reload the page and try again.");
    wish.about = form.value("about");
    wish.points = form.value("points");
    wish.text = form.value("text");
    std::erase(wish.text, '\r');  // browsers end lines with CR LF
    wish.accepts_concerns = form.has("accepts");
    const std::string lines = form.value("lines");
    if (wish.kind == Kind::reading && !form.has("none")) {
        wish.lines = lines;
        if (lines.empty()) throw UsageError("Enter the lines that hold the answer, or check \"not printed\".");
    }
    return wish;
}

}  // namespace

Site::Site(Session& session, const std::string& secret)
    : session_(session), root_("/" + secret), pages_(session, root_) {
    set_up_sodium();
}

/// Takes the same time for every wrong secret.
std::optional<std::string> Site::path_below_secret(const std::string& path) const {
    if (path.size() < root_.size() || sodium_memcmp(path.data(), root_.data(), root_.size()) != 0) return std::nullopt;
    std::string rest = path.substr(root_.size());
    if (!rest.empty() && rest.front() != '/') return std::nullopt;
    return rest;
}

std::optional<Response> Site::answer(const Head& head) {
    if (head.host.empty() || !head.path.starts_with('/')) return problem(head, 400);
    if (!serve::is_for_us(head, {}))
        return plain(
            421, "This server accepts only requests for 127.0.0.1. Open the address that `raygrade review` printed.");
    const auto path = path_below_secret(head.path);
    if (!path) return plain(404, "There is no page at this address. Open the address that `raygrade review` printed.");
    const bool is_post = is_post_path(*path);
    if (is_post ? head.method != Method::post : head.method != Method::get && head.method != Method::head) {
        Response response = page(405, pages_.message("Not allowed", "This page does not accept that kind of request."));
        response.fields.emplace_back("Allow", is_post ? "POST" : "GET, HEAD");
        return response;
    }
    if (is_post) {
        if (serve::is_from_us(head, {})) return std::nullopt;
        return page(403, pages_.message("Sent from a different website",
                                        "This was sent from a different website, so it was ignored."));
    }
    if (auto found = asset(*path)) return found;
    if (path->empty()) return redirect(root_ + "/");
    try {
        session_.refresh();
        return show(*path);
    } catch (const UsageError& error) {
        return page(503, pages_.message("Please try again later", error.what()));
    } catch (const HarnessError& error) {
        return page(500, pages_.message("Please try again later", error.what()));
    }
}

Response Site::show(const std::string& path) {
    constexpr std::string_view student = "/student/", done = "/done/";
    const auto notice = [&](std::string_view number) -> std::optional<Notice> {
        const auto decision = number_in(number);
        const std::string sentence = decision ? sentence_of(session_.kept(), *decision) : "";
        if (sentence.empty()) return std::nullopt;
        const std::string lowered = lowered_sentence(session_.kept(), *decision);
        return Notice{sentence + (lowered.empty() ? "" : " " + lowered), false, decision};
    };
    if (path == "/") return page(200, pages_.list(std::nullopt));
    if (path.starts_with(done)) return page(200, pages_.list(notice(path.substr(done.size()))));
    if (path.starts_with(student)) {
        std::string_view rest = std::string_view(path).substr(student.size());
        const std::string_view digits = rest.substr(0, rest.find('/'));
        rest.remove_prefix(digits.size());
        const auto number = number_in(digits);
        if (number && static_cast<std::size_t>(*number) <= session_.graded().size()) {
            const auto index = static_cast<std::size_t>(*number) - 1;
            if (rest.empty()) return page(200, pages_.student(index, std::nullopt));
            if (rest.starts_with(done)) return page(200, pages_.student(index, notice(rest.substr(done.size()))));
        }
    }
    return page(404, pages_.message("Page not found", "This page does not exist. The class may have changed."));
}

Response Site::take_in(const Head& head, const std::string& body) {
    const auto path = path_below_secret(head.path);
    const auto form = read_form(head.content_type, body);
    if (!path || !form) return problem(head, 400);
    try {
        session_.refresh();
        try {
            return post(*path, *form);
        } catch (const UsageError& error) {
            session_.refresh();
            return refused(error, *form);
        }
    } catch (const UsageError& error) {
        return page(503, pages_.message("Please try again later", error.what()));
    } catch (const HarnessError& error) {
        return page(500, pages_.message("Something went wrong", error.what()));
    }
}

Response Site::post(const std::string& path, const FormFields& form) {
    if (path == "/decide") return decide_for_one_or_ask(form);
    if (path == "/apply") return apply(form);
    if (path == "/undo") return undo_one(form);
    return take_back(form);
}

/// Shows the student's page again, with the reason and the typed text.
Response Site::refused(const UsageError& error, const FormFields& form) {
    const bool has_changed = dynamic_cast<const ChangedMeanwhile*>(&error) != nullptr;
    const int status = has_changed ? 409 : 422;
    const auto index = index_of(session_.kept(), form.value("student"));
    if (!index) return page(status, pages_.message("Nothing was changed", error.what()));
    std::optional<Wish> tried;
    try {
        if (form.has("kind")) tried = wish_in(form);
    } catch (const UsageError&) {
        tried = std::nullopt;
    }
    return page(status, pages_.student(*index, Notice{error.what(), true, std::nullopt}, tried));
}

Response Site::decide_for_one_or_ask(const FormFields& form) {
    const Wish wish = wish_in(form);
    const Shown shown{form.value("student"), form.value("state")};
    const std::size_t index = session_.indices_of({shown}).front();
    if (form.value("for") != "alike") return after_decision(decide(session_, {shown}, wish), shown.id, wish);
    after(session_, index, wish);  // so that an impossible decision is reported at once
    Group group = alike(session_, index, wish);
    if (group.indices.size() < 2) {
        throw UsageError(
            fmt::format("No other student has {}, so nothing was done. Decide for this student only.", group.cause));
    }
    return page(200, pages_.group(index, wish, group));
}

Response Site::apply(const FormFields& form) {
    const Wish wish = wish_in(form);
    std::vector<Shown> chosen;
    for (const std::string& who : form.values("who")) {
        if (who.size() > state_digits) chosen.push_back({who.substr(state_digits), who.substr(0, state_digits)});
    }
    if (chosen.empty()) throw UsageError("No student was selected, so nothing was done.");
    return after_decision(decide(session_, chosen, wish), form.value("student"), wish);
}

/// After accepting a concern, shows the next student; after anything else, the changed page.
Response Site::after_decision(std::int64_t number, const std::string& id, const Wish& wish) {
    auto index = index_of(session_.kept(), id);
    const bool is_done = index && open_concerns(session_.graded()[*index]).empty();
    if (index && wish.kind == Kind::accepted && is_done) index = next_open(agenda_of(session_), *index);
    return redirect(fmt::format("{}/done/{}", index ? pages_.path_of(*index) : root_, number));
}

Response Site::undo_one(const FormFields& form) {
    const auto number = number_in(form.value("number"));
    const std::string what = number ? sentence_of(session_.kept(), *number) : "";
    if (what.empty()) throw UsageError("This decision does not exist any more; it may have been undone already.");
    const Undone undone = undo(session_, *number);
    std::string sentence = fmt::format("Undone: {}", what);
    if (!undone.left.empty()) {
        std::vector<std::string> left;
        for (const std::string& id : undone.left) left.push_back(name_of(session_.kept(), id));
        sentence += fmt::format(" It stays for {}, because somebody has changed it since.", fmt::join(left, "; "));
    }
    const std::string back = form.value("back");
    std::optional<std::size_t> index;
    if (!back.empty()) {
        const bool is_here =
            std::find(undone.submissions.begin(), undone.submissions.end(), back) != undone.submissions.end();
        index = index_of(session_.kept(), is_here || undone.submissions.empty() ? back : undone.submissions.back());
    }
    const Notice notice{sentence, false, std::nullopt};
    return page(200, index ? pages_.student(*index, notice) : pages_.list(notice));
}

Response Site::take_back(const FormFields& form) {
    const Shown shown{form.value("student"), form.value("state")};
    const std::size_t index = session_.indices_of({shown}).front();
    const std::string what = form.value("what"), about = form.value("about");
    if (what == "override") {
        review::take_back(session_, shown, Kind::points, about);
    } else if (what == "reread") {
        review::take_back(session_, shown, Kind::reading, about);
    } else {
        const auto number = number_in(about);
        if (!number) throw UsageError("This decision does not exist any more.");
        undo(session_, *number, shown.id);
    }
    return redirect(pages_.path_of(index));
}

Response Site::problem(const Head& /*head*/, int status) const {
    switch (status) {
        case 413: return plain(status, "The form is too large. Shorten its text.");
        case 431: return plain(status, "The header of this request is too large.");
        case 500: return plain(status, "Something went wrong. See the terminal where `raygrade review` runs.");
        default: return plain(400, "This server does not understand that request.");
    }
}

}  // namespace harness::review
