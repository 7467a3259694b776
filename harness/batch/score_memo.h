// The scores of outputs, for a class in which many programs print the same: each output is read and scored once.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "harness/mark/score/score.h"

namespace harness {

/// Remembers the scores of the last `most` outputs, all under one Marking. Safe to use from several threads.
class ScoreMemo {
  public:
    /// The score of this output; null if it is not remembered.
    std::shared_ptr<const Score> find(const std::string& output) const;
    void keep(const std::string& output, std::shared_ptr<const Score> score);

    static constexpr std::size_t most = 512;  ///< each about 20 KB

  private:
    mutable std::mutex mutex_;
    std::unordered_map<std::string, std::shared_ptr<const Score>> scores_;  ///< by the output's fingerprint
    std::deque<std::string> order_;                                         ///< the oldest first
};

}  // namespace harness
