// What is worked out once for a class under one Marking: the scores of outputs, as many programs print the same, and
// the keys of scenes that sources may state, as a guess at the pixel fits many sources.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

#include "harness/mark/score/score.h"
#include "harness/record/marking.h"

namespace harness {

/// Remembers the scores of the last outputs, all under one Marking, and the keys of the last scenes, all with one
/// rubric and questions. Safe to use from several threads.
class ScoreMemo {
  public:
    static constexpr std::size_t most = 512;  ///< scores; each takes about 20 KB; none are kept with 0

    explicit ScoreMemo(std::size_t most_scores = most) : most_scores_(most_scores) {}

    /// The score of this output; null if it is not remembered.
    std::shared_ptr<const Score> find(const std::string& output) const;
    void keep(const std::string& output, std::shared_ptr<const Score> score);

    /// The marking with `scene` in the assignment's place; null if it can't be marked. `make` makes it unless it is
    /// remembered.
    std::shared_ptr<const Marking> on_scene(const reference::Scene<reference::Decimal>& scene,
                                            const std::function<std::shared_ptr<const Marking>()>& make);

  private:
    /// The last values that were kept, by name.
    template <class Value>
    struct Last {
        std::unordered_map<std::string, std::shared_ptr<const Value>> values{};
        std::deque<std::string> order{};  ///< the oldest first

        void keep(std::string name, std::shared_ptr<const Value> value, std::size_t most_kept) {
            if (!values.emplace(name, std::move(value)).second) return;  // another thread added it first
            order.push_back(std::move(name));
            if (order.size() <= most_kept) return;
            values.erase(order.front());
            order.pop_front();
        }
    };

    const std::size_t most_scores_;
    mutable std::mutex mutex_;
    Last<Score> scores_;      ///< by the output's fingerprint
    Last<Marking> markings_;  ///< by the scene as TOML
};

}  // namespace harness
