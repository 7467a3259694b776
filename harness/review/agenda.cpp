#include "harness/review/agenda.h"

#include <algorithm>
#include <limits>

#include "harness/record/concern_titles.h"
#include "harness/record/concerns.h"
#include "harness/review/decide.h"

namespace harness::review {
namespace {

/// The urgency of the most urgent concern, open or accepted; a submission without one comes last.
std::size_t urgency(const Graded& graded) {
    const std::vector<Flag> concerns = concerns_of(graded);
    return concerns.empty() ? std::numeric_limits<std::size_t>::max() : urgency_of(concerns.front().kind);
}

Chapter& chapter_of(std::vector<Chapter>& chapters, const std::string& kind) {
    const auto found =
        std::find_if(chapters.begin(), chapters.end(), [&](const Chapter& chapter) { return chapter.kind == kind; });
    return found == chapters.end() ? chapters.emplace_back(Chapter{kind, {}}) : *found;
}

bool holds(const Case& one, std::size_t index) {
    return std::find(one.indices.begin(), one.indices.end(), index) != one.indices.end();
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
            if (group.indices.empty()) group.indices.push_back(i);
            chapter.cases.push_back({concern, std::move(group.indices)});
        }
    }
    std::stable_sort(agenda.chapters.begin(), agenda.chapters.end(),
                     [](const Chapter& a, const Chapter& b) { return urgency_of(a.kind) < urgency_of(b.kind); });
    std::stable_sort(agenda.order.begin(), agenda.order.end(),
                     [&](std::size_t a, std::size_t b) { return urgency(graded[a]) < urgency(graded[b]); });
    std::copy_if(agenda.order.begin(), agenda.order.end(), std::back_inserter(agenda.open),
                 [&](std::size_t i) { return !open_concerns(graded[i]).empty(); });
    return agenda;
}

std::optional<std::size_t> before(const Agenda& agenda, std::size_t index) {
    const auto here = std::find(agenda.order.begin(), agenda.order.end(), index);
    if (here == agenda.order.begin() || here == agenda.order.end()) return std::nullopt;
    return *(here - 1);
}

std::optional<std::size_t> next(const Agenda& agenda, std::size_t index) {
    const auto here = std::find(agenda.order.begin(), agenda.order.end(), index);
    if (here == agenda.order.end() || here + 1 == agenda.order.end()) return std::nullopt;
    return *(here + 1);
}

std::optional<std::size_t> next_open(const Agenda& agenda, std::size_t index) {
    const auto is_open = [&](std::size_t i) {
        return i != index && std::find(agenda.open.begin(), agenda.open.end(), i) != agenda.open.end();
    };
    const auto here = std::find(agenda.order.begin(), agenda.order.end(), index);
    const auto later = std::find_if(here, agenda.order.end(), is_open);
    if (later != agenda.order.end()) return *later;
    const auto earlier = std::find_if(agenda.order.begin(), here, is_open);
    return earlier == here ? std::nullopt : std::optional(*earlier);
}

}  // namespace harness::review
