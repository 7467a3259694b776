#include "harness/match/without_headings.h"

#include <algorithm>

namespace harness {
namespace {

using reference::ItemSpec;
using reference::Shape;

constexpr std::size_t most_values = 96;

/// The longest run that is tried for these items. A matrix may take one value per row, and some values may be asides.
std::size_t longest_run(const std::vector<ItemSpec>& items) {
    constexpr std::size_t asides = 3;
    std::size_t values = items.size() + asides;
    for (const ItemSpec& item : items) {
        if (item.shape == Shape::matrix3) values += 2;
        if (item.shape == Shape::matrix4) values += 3;
    }
    return values;
}

class Division {
  public:
    Division(std::span<const std::vector<ItemSpec>> questions, const std::vector<PrintedValue>& values, Fits& fits)
        : questions_(questions), values_(values), fits_(fits) {}

    std::vector<Answers> run() {
        // gain[q][j]: the best gain of questions [0, q) with values [0, j). length[q][j]: the length of the run that
        // ends at j; 0 if there is none.
        const std::size_t columns = values_.size() + 1;
        std::vector<std::vector<std::int64_t>> gain(questions_.size() + 1, std::vector<std::int64_t>(columns, 0));
        std::vector<std::vector<std::size_t>> length(questions_.size() + 1, std::vector<std::size_t>(columns, 0));
        std::vector<std::vector<bool>> skips(questions_.size() + 1, std::vector<bool>(columns, false));
        for (std::size_t q = 1; q <= questions_.size(); ++q) {
            for (std::size_t j = 0; j < columns; ++j) {
                gain[q][j] = gain[q - 1][j];
                const std::size_t longest = std::min(j, longest_run(questions_[q - 1]));
                const auto most = static_cast<std::int64_t>(questions_[q - 1].size()) * largest_gain;
                for (std::size_t n = 1; n <= longest && gain[q - 1][j - n] + most > gain[q][j]; ++n) {
                    const std::int64_t with = gain[q - 1][j - n] + answers(q - 1, j - n, n).gain;
                    if (with <= gain[q][j]) continue;
                    gain[q][j] = with;
                    length[q][j] = n;
                }
                if (j > 0 && gain[q][j - 1] >= gain[q][j]) {
                    gain[q][j] = gain[q][j - 1];
                    skips[q][j] = true;
                }
            }
        }
        std::vector<Answers> result(questions_.size());
        std::size_t j = values_.size();
        for (std::size_t q = questions_.size(); q > 0; --q) {
            while (skips[q][j]) --j;
            result[q - 1] = answers(q - 1, j - length[q][j], length[q][j]);
            j -= length[q][j];
        }
        return result;
    }

  private:
    Answers answers(std::size_t q, std::size_t begin, std::size_t n) {
        const auto first = values_.begin() + static_cast<std::ptrdiff_t>(begin);
        const std::vector<PrintedValue> run(first, first + static_cast<std::ptrdiff_t>(n));
        return answer_question(questions_[q], {&run, 1}, Need::order_or_label, fits_);
    }

    std::span<const std::vector<ItemSpec>> questions_;
    const std::vector<PrintedValue>& values_;
    Fits& fits_;
};

std::size_t count_labelled(const std::vector<Answers>& answers, std::span<const std::vector<ItemSpec>> questions,
                           Fits& fits) {
    std::size_t count = 0;
    for (std::size_t q = 0; q < questions.size(); ++q) {
        for (std::size_t i = 0; i < questions[q].size(); ++i) {
            const auto& candidate = answers[q].candidate_of[i];
            if (candidate && fits(answers[q].candidates[*candidate].value, questions[q][i]) >= LabelFit::named) ++count;
        }
    }
    return count;
}

std::vector<Answers> by_labels(std::span<const std::vector<ItemSpec>> questions,
                               const std::vector<PrintedValue>& values, Fits& fits) {
    std::vector<Answers> result;
    std::vector<PrintedValue> left = values;
    for (const std::vector<ItemSpec>& items : questions) {
        result.push_back(answer_question(items, {&left, 1}, Need::label, fits));
        left = unused_values({&left, 1}, result.back());
    }
    return result;
}

}  // namespace

std::vector<Answers> answer_unheaded(std::span<const std::vector<ItemSpec>> questions,
                                     const std::vector<PrintedValue>& values, Fits& fits) {
    std::vector<Answers> labelled = by_labels(questions, values, fits);
    if (values.size() > most_values) return labelled;
    std::vector<Answers> in_order = Division(questions, values, fits).run();
    return count_labelled(labelled, questions, fits) > count_labelled(in_order, questions, fits) ? labelled : in_order;
}

}  // namespace harness
