// The keys of scenes that sources may state. Many sources of a class state the same scene, so each key is made once.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "harness/record/marking.h"

namespace harness {

/// Remembers the keys of the first scenes, all with one rubric and questions. Safe to use from several threads.
class SceneMemo {
  public:
    /// The marking with `scene` in the assignment's place; null if it can't be marked. `make` makes it unless it is
    /// remembered.
    std::shared_ptr<const Marking> on_scene(const reference::Scene<reference::Decimal>& scene,
                                            const std::function<std::shared_ptr<const Marking>()>& make);

  private:
    std::mutex mutex_;
    std::map<std::string, std::shared_ptr<const Marking>> markings_;  ///< by the scene as TOML
};

}  // namespace harness
