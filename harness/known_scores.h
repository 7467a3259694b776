// What outputs are worth, for a class where many print the same: each output is read and scored once.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "harness/grade.h"

namespace harness {

/// Which of its submission's runs printed an output.
enum class Turn { first, repeated };

/// Remembers the scores of the last outputs that differ. For many threads. A Marking must outlive it.
class KnownScores {
  public:
    /// As reading `output` and scoring it for `marking` gives; `of` names the submission in the timeline, which counts
    /// those that printed what another had.
    Score score(const std::string& output, const Marking& marking, Timeline& timeline, const std::string& of,
                Turn turn = Turn::first);

    /// How many are remembered: some 20 KB each.
    static constexpr std::size_t most = 512;

  private:
    std::shared_ptr<const Score> find(const std::string& name);
    void keep(const std::string& name, std::shared_ptr<const Score> score);

    std::mutex mutex_;
    std::unordered_map<std::string, std::shared_ptr<const Score>> scores_;  ///< by fingerprint
    std::deque<std::string> order_;                                         ///< the oldest first
};

}  // namespace harness
