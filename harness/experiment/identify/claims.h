// The numbers claimed for each item so far, and their values on the other scenes.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "harness/experiment/identify/candidate.h"
#include "harness/experiment/identify/slots.h"
#include "harness/mark/compare/closeness.h"
#include "harness/record/experiment.h"
#include "reference/key/answer_key.h"

namespace harness::experiment {

/// The program's output on another scene.
struct Observation {
    Transcript transcript;
    const reference::AnswerKey& key;  ///< that scene's
    const reference::Assignment& assignment;
};

/// The evidence for a claim, best first.
enum class Evidence {
    right,
    follows,        ///< from the items claimed before
    named_mistake,  ///< the same on every scene
    rest,           ///< no other number is left that may be the item
};

struct Claim {
    Candidate candidate;
    Evidence evidence = Evidence::right;
};

class Claims {
  public:
    /// All arguments must outlive this object.
    Claims(const Slots& slots, std::span<const Observation> others, std::span<const reference::ItemSpec> items)
        : slots_(slots.numbers), others_(others), items_(items), used_(slots_.size(), false), targets_(others.size()) {}

    /// Marks the numbers as used: a number belongs to only one item.
    void add(const reference::ItemSpec& item, Candidate candidate, Evidence evidence);
    const std::map<reference::ItemId, Claim>& all() const { return claims_; }
    /// The claim for the item; null if there is none.
    const Claim* of(const reference::ItemId& id) const;
    bool is_used(std::size_t slot) const { return used_[slot]; }
    bool is_used(const std::vector<std::size_t>& slots) const;

    bool moves(const Candidate& candidate) const;
    /// Whether the candidate is right on every other scene.
    bool is_right(const reference::ItemSpec& item, const Candidate& candidate);
    /// The evidence for the candidate on the other scenes, given the items found before; empty if one scene has no
    /// evidence or the scenes differ.
    std::optional<Evidence> evidence_of(const reference::ItemSpec& item, const Candidate& candidate) const;
    /// The named mistakes of the items that are wrong on every other scene.
    std::vector<MistakeOnScenes> mistakes() const;

  private:
    MatchedItem on_scene(std::size_t scene, const reference::ItemSpec& item, const Candidate& candidate) const;
    std::vector<MatchedItem> all_on_scene(std::size_t scene) const;
    bool is_right(std::size_t scene, const reference::ItemSpec& item, const Candidate& candidate);

    const std::vector<Slot>& slots_;
    std::span<const Observation> others_;
    std::span<const reference::ItemSpec> items_;
    std::vector<bool> used_;
    std::map<reference::ItemId, Claim> claims_;
    std::vector<std::map<reference::ItemId, std::vector<Target>>> targets_;  ///< by scene
};

/// Whether the item may follow from one of these inputs.
bool depends_on(const reference::ItemId& id, const std::set<reference::ItemId>& inputs);

}  // namespace harness::experiment
