// Which of the values printed for a question answers which of its items: one assignment problem, solved exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "harness/arrange.h"
#include "harness/label.h"
#include "harness/transcript.h"
#include "reference/items.h"

namespace harness {

/// How well printed values name items: by the words before the value; without any by those behind it, or on the line
/// above. Remembers, since a program repeats its labels.
class Fits {
  public:
    using Row = std::vector<LabelFit>;  ///< by the item's place in reference::all_items()

    /// Of all items at once. The reference stays good.
    const Row& of(const PrintedValue& value);
    LabelFit operator()(const PrintedValue& value, const reference::ItemSpec& item);

  private:
    std::unordered_map<std::string, Row> known_;
};

/// Whether a value may have the item's shape; a value without numbers has that of an item that may not exist.
bool has_shape(const PrintedValue& value, const reference::ItemSpec& item);

/// Items whose value may not exist: a ray can miss.
bool may_be_absent(const reference::ItemSpec& item);

/// What a question asks a value for: to come in its order or to be labelled, or to be labelled in any case.
enum class Need { order_or_label, label };

/// The values that answer a question's items.
struct Answers {
    std::vector<Candidate> candidates;
    std::vector<std::optional<std::size_t>> candidate_of;  ///< by item: an index into candidates
    std::int64_t gain = 0;                                 ///< the sum of the fits: larger is better
};

/// No item adds more to the gain.
constexpr std::int64_t largest_gain = 110'000;

/// `items` of one question, in the handout's order; `parts` are the runs of values that were printed for it, the last
/// of which counts most. At most one value an item and one item a value, so that the sum of the fits is largest. Label,
/// type and order decide, no number is looked at. Linear in the number of values.
Answers answer_question(std::span<const reference::ItemSpec> items, std::span<const std::vector<PrintedValue>> parts,
                        Need need, Fits& fits);

/// The values of all parts that answer none of the items.
std::vector<PrintedValue> unused_values(std::span<const std::vector<PrintedValue>> parts, const Answers& answers);

}  // namespace harness
