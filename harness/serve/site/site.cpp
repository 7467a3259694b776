#include "harness/serve/site/site.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "harness/serve/queue/result_address.h"
#include "harness/serve/site/assets.h"
#include "harness/serve/site/form.h"

namespace harness::serve {
namespace {

using nlohmann::json;

constexpr std::string_view result_path = "/result/";
constexpr std::string_view standing_path = "/standing";
constexpr int some_seconds = 30;

Response page(int status, std::string html, std::string policy) {
    return {status, "text/html; charset=utf-8", std::move(html), {{"Content-Security-Policy", std::move(policy)}}};
}

Response as_json(int status, const json& value) {
    // A sentence may contain any bytes of the client; invalid UTF-8 is replaced, so that this does not throw.
    return {status, "application/json", value.dump(-1, ' ', false, json::error_handler_t::replace), {}};
}

/// The relative path from `path` to the front page: one step up for each folder.
std::string way_to_top(std::string_view path) {
    constexpr std::ptrdiff_t deepest = 8;
    const auto folders = std::count(path.begin(), path.end(), '/') - 1;
    if (folders <= 0 || folders > deepest) return ".";
    std::string way = "..";
    for (std::ptrdiff_t i = 1; i < folders; ++i) way += "/..";
    return way;
}

std::string_view name_of(const Standing& standing) {
    struct Name {
        std::string_view operator()(const Waiting&) const { return "waiting"; }
        std::string_view operator()(const BeingGraded&) const { return "grading"; }
        std::string_view operator()(const Done&) const { return "done"; }
        std::string_view operator()(const Lost&) const { return "lost"; }
        std::string_view operator()(const Unknown&) const { return "unknown"; }
    };
    return std::visit(Name(), standing);
}

std::optional<Response> asset(const std::string& path) {
    if (path == "/style.css") return Response{200, "text/css; charset=utf-8", std::string(assets::style_css), {}};
    if (path == "/script.js")
        return Response{200, "text/javascript; charset=utf-8", std::string(assets::script_js), {}};
    // Browsers ask for /favicon.ico if a page names no icon.
    if (path == "/icon.svg" || path == "/favicon.ico")
        return Response{200, "image/svg+xml", std::string(assets::icon_svg), {}};
    return {};
}

}  // namespace

Response Site::say(const Head& head, int status, const std::string& heading, const std::string& sentence) const {
    if (head.wants_json) return as_json(status, {{"error", sentence}});
    return page(status, message_page(settings_.about, heading, sentence, way_to_top(head.path)), own_policy());
}

std::optional<Response> Site::answer(const Head& head) {
    if (head.host.empty() || !head.path.starts_with('/')) return problem(head, 400);
    if (!is_for_us(head, settings_.reach)) {
        return say(head, 421, "Wrong address",
                   "This server does not answer to the name in your browser's address bar. Please use the address your "
                   "instructor gave you; instructors, see --name in `raygrade serve --help`.");
    }
    const bool is_check = head.path == "/check";
    const bool is_known_method =
        head.method == (is_check ? Method::post : Method::get) || (!is_check && head.method == Method::head);
    if (!is_known_method) {
        Response response = say(head, 405, "Not allowed", "This page does not accept that kind of request.");
        response.fields.emplace_back("Allow", is_check ? "POST" : "GET, HEAD");
        return response;
    }
    if (is_check) return answer_check(head);
    if (head.path == "/") return page(200, front_page(settings_.about), own_policy());
    if (auto found = asset(head.path)) return found;
    if (head.path.starts_with(result_path)) {
        std::string address = head.path.substr(result_path.size());
        const bool asks_standing = address.ends_with(standing_path);
        if (asks_standing) address.resize(address.size() - standing_path.size());
        if (is_result_address(address)) return asks_standing ? answer_standing(address) : answer_result(head, address);
    }
    return say(head, 404, "Page not found", sentence_of(Unknown{}));
}

std::optional<Response> Site::answer_check(const Head& head) const {
    if (!is_from_us(head, settings_.reach)) {
        return say(
            head, 403, "Sent from a different website",
            "This was sent from a different website, so it was ignored. Please go back to the form here and send "
            "your program from there.");
    }
    if (const auto refusal = queue_.refusal()) return refuse(head, *refusal);
    return {};
}

Response Site::refuse(const Head& head, Refusal refusal) const {
    std::string sentence;
    switch (refusal) {
        case Refusal::full:
            sentence =
                "Too many programs are waiting. Please send yours again in half a "
                "minute.";
            break;
        case Refusal::no_room_on_disk:
            sentence =
                "This machine could not store your program because its disk is full or failing. Please tell your "
                "instructor.";
            break;
    }
    Response response = say(head, 503, "Please try again later", sentence);
    response.fields.emplace_back("Retry-After", std::to_string(some_seconds));
    return response;
}

Response Site::take_in(const Head& head, const std::string& body) {
    const HandedIn handed = source_of(head.content_type, body);
    if (!handed.problem.empty()) return say(head, 400, "No program found", handed.problem);
    const auto accepted = queue_.accept(handed.source, handed.file);
    if (const auto* refusal = std::get_if<Refusal>(&accepted)) return refuse(head, *refusal);
    const std::string address = "result/" + std::get<std::string>(accepted);
    Response response = head.wants_json ? as_json(201, {{"result", address}})
                                        : page(303, "<!DOCTYPE html><title>Accepted</title>\n", own_policy());
    response.fields.emplace_back("Location", address);
    return response;
}

Response Site::answer_result(const Head& head, const std::string& result_address) const {
    const Standing standing = queue_.standing(result_address);
    if (std::holds_alternative<Waiting>(standing) || std::holds_alternative<BeingGraded>(standing)) {
        return page(200, waiting_page(settings_.about, result_address, standing), own_policy());
    }
    if (std::holds_alternative<Done>(standing)) {
        if (const auto found = queue_.page(result_address)) return page(200, *found, student_policy(*found));
    }
    if (std::holds_alternative<Lost>(standing)) return say(head, 500, "Not checked", sentence_of(standing));
    return say(head, 404, "No result here", sentence_of(Unknown{}));
}

Response Site::answer_standing(const std::string& result_address) const {
    const Standing standing = queue_.standing(result_address);
    json value = {{"standing", name_of(standing)}, {"sentence", sentence_of(standing)}};
    if (const auto* waiting = std::get_if<Waiting>(&standing)) {
        value["position"] = waiting->position;
        value["length"] = waiting->length;
    }
    if (const auto* done = std::get_if<Done>(&standing)) {
        value["points"] = done->points ? json(*done->points) : json(nullptr);
        value["max_points"] = done->max_points;
    }
    return as_json(std::holds_alternative<Unknown>(standing) ? 404 : 200, value);
}

Response Site::problem(const Head& head, int status) const {
    switch (status) {
        case 413:
            return say(head, status, "Too large",
                       "Your file is larger than 1 MiB. Please send only the source, without data or output in it.");
        case 431: return say(head, status, "Too large", "The header of this request is too large.");
        case 500:
            return say(head, status, "Please try again later",
                       "Something went wrong on this machine. Please try again. If it happens again, tell your "
                       "instructor.");
        default: return say(head, 400, "Bad request", "This server does not understand that request.");
    }
}

}  // namespace harness::serve
