#include "harness/review/agenda.h"

#include <algorithm>
#include <array>

#include "harness/grade/concerns.h"
#include "harness/review/decide.h"

namespace harness::review {
namespace {

/// By urgency; a kind that is not here comes before `not_graded`.
constexpr std::array<std::string_view, 6> early_kinds{"reading_doubtful", "hard_coded",       "other_scene",
                                                      "scene_of_another", "nondeterministic", "variants_not_tried"};
constexpr std::array<std::string_view, 2> late_kinds{not_graded_concern, "late_without_date"};

std::size_t urgency(const std::string& kind) {
    const auto early = std::find(early_kinds.begin(), early_kinds.end(), kind);
    const auto late = std::find(late_kinds.begin(), late_kinds.end(), kind);
    if (late != late_kinds.end()) return early_kinds.size() + 1 + static_cast<std::size_t>(late - late_kinds.begin());
    return static_cast<std::size_t>(early - early_kinds.begin());
}

/// That of the most urgent concern, open or accepted; after all others if there is none.
std::size_t urgency(const Graded& graded) {
    std::size_t least = early_kinds.size() + late_kinds.size() + 1;
    for (const Flag& concern : concerns_of(graded)) least = std::min(least, urgency(concern.kind));
    return least;
}

Chapter& chapter_of(std::vector<Chapter>& chapters, const std::string& kind) {
    const auto found =
        std::find_if(chapters.begin(), chapters.end(), [&](const Chapter& each) { return each.kind == kind; });
    return found == chapters.end() ? chapters.emplace_back(Chapter{kind, {}}) : *found;
}

bool holds(const Case& one, std::size_t place) {
    return std::find(one.places.begin(), one.places.end(), place) != one.places.end();
}

}  // namespace

Agenda agenda_of(const Session& session) {
    Agenda agenda;
    const std::vector<Graded>& graded = session.graded();
    for (std::size_t i = 0; i < graded.size(); ++i) {
        agenda.order.push_back(i);
        agenda.concerned += concerns_of(graded[i]).empty() ? 0 : 1;
        for (const Flag& concern : open_concerns(graded[i])) {
            Chapter& chapter = chapter_of(agenda.chapters, concern.kind);
            const bool is_known = std::any_of(chapter.cases.begin(), chapter.cases.end(),
                                              [&](const Case& each) { return holds(each, i); });
            if (is_known) continue;
            Group group = alike(session, i, {Decision::Kind::accepted, concern.kind, {}, {}, {}, false});
            if (group.places.empty()) group.places.push_back(i);
            chapter.cases.push_back({concern, std::move(group.places)});
        }
    }
    std::stable_sort(agenda.chapters.begin(), agenda.chapters.end(),
                     [](const Chapter& a, const Chapter& b) { return urgency(a.kind) < urgency(b.kind); });
    std::stable_sort(agenda.order.begin(), agenda.order.end(),
                     [&](std::size_t a, std::size_t b) { return urgency(graded[a]) < urgency(graded[b]); });
    std::copy_if(agenda.order.begin(), agenda.order.end(), std::back_inserter(agenda.open),
                 [&](std::size_t i) { return !open_concerns(graded[i]).empty(); });
    return agenda;
}

std::optional<std::size_t> before(const Agenda& agenda, std::size_t place) {
    const auto here = std::find(agenda.order.begin(), agenda.order.end(), place);
    if (here == agenda.order.begin() || here == agenda.order.end()) return std::nullopt;
    return *(here - 1);
}

std::optional<std::size_t> next(const Agenda& agenda, std::size_t place) {
    const auto here = std::find(agenda.order.begin(), agenda.order.end(), place);
    if (here == agenda.order.end() || here + 1 == agenda.order.end()) return std::nullopt;
    return *(here + 1);
}

std::optional<std::size_t> next_open(const Agenda& agenda, std::size_t place) {
    const auto is_open = [&](std::size_t i) {
        return i != place && std::find(agenda.open.begin(), agenda.open.end(), i) != agenda.open.end();
    };
    const auto here = std::find(agenda.order.begin(), agenda.order.end(), place);
    const auto later = std::find_if(here, agenda.order.end(), is_open);
    if (later != agenda.order.end()) return *later;
    const auto earlier = std::find_if(agenda.order.begin(), here, is_open);
    return earlier == here ? std::nullopt : std::optional(*earlier);
}

}  // namespace harness::review
