#include "harness/known_scores.h"

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

Score KnownScores::score(const std::string& output, const Marking& marking, Timeline& timeline, const std::string& of) {
    const std::string name = name_of(output, marking);
    {
        const std::lock_guard guard(mutex_);
        const auto known = scores_.find(name);
        if (known != scores_.end()) return *known->second;
    }
    Transcript transcript;
    {
        const Timeline::Span span(timeline, Stage::read, of);
        transcript = read_transcript(output);
    }
    const Timeline::Span span(timeline, Stage::score, of);
    const auto score = std::make_shared<const Score>(harness::score(transcript, marking.key, marking.assignment));
    const std::lock_guard guard(mutex_);
    if (!scores_.emplace(name, score).second) return *score;
    order_.push_back(name);
    if (order_.size() > most) {
        scores_.erase(order_.front());
        order_.pop_front();
    }
    return *score;
}

}  // namespace harness
