// Matches the values printed for a question with its items: one assignment problem, solved exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "harness/match/candidates.h"
#include "harness/match/label.h"
#include "harness/read/transcript.h"
#include "reference/stages/items.h"

namespace harness {

/// How well the words around printed values name items (fit_value). Caches the results, because a program repeats its
/// labels.
class Fits {
  public:
    using Row = std::vector<LabelFit>;  ///< by the item's place in `asked`

    /// `asked` are the items of all questions; they must outlive the fits.
    explicit Fits(std::span<const reference::ItemSpec> asked) : asked_(asked) {}
    std::span<const reference::ItemSpec> asked() const { return asked_; }
    std::size_t index_of(const reference::ItemSpec& item) const;

    /// The fits of a value to all items. The reference stays valid.
    const Row& of(const PrintedValue& value);
    LabelFit operator()(const PrintedValue& value, const reference::ItemSpec& item);

  private:
    std::span<const reference::ItemSpec> asked_;
    std::unordered_map<std::string, Row> known_;
};

/// Whether an item of this shape may have this many numbers: a vector may include a w.
bool has_count(reference::Shape shape, std::size_t count);

/// Whether the value has the item's shape. A value without numbers, such as "none", fits an item that may be absent.
bool has_shape(const PrintedValue& value, const reference::ItemSpec& item);

/// Whether the item has no value if the ray misses.
bool may_be_absent(const reference::ItemSpec& item);

/// Whether "no hit" means that the item has no value. A ray that misses the triangle still meets its plane.
bool is_of_hit(const reference::ItemSpec& item);

/// Whether the words that say "no hit" name an object other than the item's: "the ray misses the sphere".
bool is_said_of_another(const PrintedValue& value, const reference::ItemSpec& item);

/// What identifies an answer: its order or label, or only its label.
enum class Need { order_or_label, label };

/// The values that answer a question's items.
struct Answers {
    std::vector<Candidate> candidates;
    std::vector<std::optional<std::size_t>> candidate_of;  ///< for each item, an index into candidates
};

/// Matches each item with at most one value and each value with at most one item, so that the sum of the fits is
/// largest. `items` are those of one question in the handout's order. `parts` are the runs of values that were printed
/// for the question; the last run counts most. Label, type and order decide; no number is looked at. Linear in the
/// number of values.
Answers answer_question(std::span<const reference::ItemSpec> items, std::span<const std::vector<PrintedValue>> parts,
                        Need need, Fits& fits);

/// The values of all parts that do not answer an item.
std::vector<PrintedValue> unused_values(std::span<const std::vector<PrintedValue>> parts, const Answers& answers);

}  // namespace harness
