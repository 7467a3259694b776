#include "harness/known_scores.h"

#include <utility>

#include "harness/fingerprint.h"
#include "harness/transcript.h"

namespace harness {
namespace {

std::string name_of(const std::string& output, const Marking& marking) {
    Fingerprint fingerprint("raygrade/known-scores/1");
    const auto scene = reinterpret_cast<std::uintptr_t>(&marking);
    return fingerprint.add(static_cast<std::int64_t>(scene)).add(output).hex();
}

}  // namespace

Score KnownScores::score(const std::string& output, const Marking& marking, Timeline& timeline, const std::string& of,
                         Turn turn) {
    std::string name;
    std::shared_ptr<const Score> score;
    Transcript transcript;
    {
        const Timeline::Span span(timeline, Stage::read, of);
        name = name_of(output, marking);
        score = find(name);
        if (!score) transcript = read_transcript(output);
    }
    const Timeline::Span span(timeline, Stage::score, of);
    if (score) {
        if (turn == Turn::first && !output.empty()) ++timeline.alike;
        return *score;
    }
    score = std::make_shared<const Score>(harness::score(transcript, marking.key, marking.assignment));
    keep(name, score);
    return *score;
}

std::shared_ptr<const Score> KnownScores::find(const std::string& name) {
    const std::lock_guard guard(mutex_);
    const auto known = scores_.find(name);
    return known == scores_.end() ? nullptr : known->second;
}

void KnownScores::keep(const std::string& name, std::shared_ptr<const Score> score) {
    const std::lock_guard guard(mutex_);
    if (!scores_.emplace(name, std::move(score)).second) return;  // another thread has marked the same meanwhile
    order_.push_back(name);
    if (order_.size() <= most) return;
    scores_.erase(order_.front());
    order_.pop_front();
}

}  // namespace harness
