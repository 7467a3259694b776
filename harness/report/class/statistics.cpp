#include "harness/report/class/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "harness/record/concerns.h"
#include "harness/record/final_mark.h"
#include "harness/report/text/look_first.h"

namespace harness::report {
namespace {

void count(ItemTally& tally, ItemVerdict verdict) {
    switch (verdict) {
        case ItemVerdict::right: ++tally.right; break;
        case ItemVerdict::follow: ++tally.follow; break;
        case ItemVerdict::wrong:
        case ItemVerdict::unreadable: ++tally.wrong; break;
        case ItemVerdict::missing: ++tally.missing; break;
    }
}

std::vector<ItemTally> tally_items(const std::vector<Graded>& graded) {
    std::vector<ItemTally> tallies;
    for (const Graded& result : graded) {
        if (!has_answers(result)) continue;
        std::size_t at = 0;  // every score has the same items in the same order
        for (const QuestionScore& question : result.score.questions) {
            for (const ItemScore& item : question.items) {
                if (at == tallies.size()) tallies.push_back({item.spec, question.title});
                count(tallies[at++], item.verdict);
            }
        }
    }
    std::stable_sort(tallies.begin(), tallies.end(),
                     [](const ItemTally& a, const ItemTally& b) { return a.failed() > b.failed(); });
    return tallies;
}

/// The smallest round width with which about ten bins contain all points.
double round_width(double max_points) {
    constexpr double most_bins = 11;
    for (double ten = 1;; ten *= 10) {
        for (const double width : {ten, 2 * ten, 5 * ten}) {
            if (std::ceil(max_points / width) <= most_bins) return width;
        }
    }
}

double median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

void summarise_points(ClassStatistics& statistics, const std::vector<Graded>& graded) {
    std::vector<double> points;
    for (const Graded& result : graded) {
        if (const auto mark = final_mark(result)) points.push_back(mark->points);
    }
    statistics.marked = points.size();
    statistics.bin_width = round_width(statistics.max_points);
    const double bins = std::max(1.0, std::ceil(statistics.max_points / statistics.bin_width));
    statistics.distribution.assign(static_cast<std::size_t>(bins), 0);
    if (points.empty()) return;
    double sum = 0;
    for (const double point : points) {
        sum += point;
        const double bin = std::floor(std::max(0.0, point) / statistics.bin_width);
        ++statistics.distribution[std::min(static_cast<std::size_t>(bin), statistics.distribution.size() - 1)];
    }
    statistics.mean = sum / static_cast<double>(points.size());
    statistics.median = median_of(std::move(points));
}

}  // namespace

double ItemTally::failed() const {
    return all() == 0 ? 0 : static_cast<double>(wrong + missing) / static_cast<double>(all());
}

bool has_answers(const Graded& graded) {
    return !holds_no_answer(graded.score);
}

ClassStatistics class_statistics(const std::vector<Graded>& graded) {
    ClassStatistics statistics;
    statistics.handed_in = graded.size();
    if (!graded.empty()) statistics.max_points = graded.front().score.max_points;
    std::map<Outcome, std::vector<std::size_t>> outcomes;
    for (std::size_t i = 0; i < graded.size(); ++i) {
        const Graded& result = graded[i];
        outcomes[result.execution.outcome].push_back(i);
        statistics.late += result.submission.lms && result.submission.lms->late == true ? 1 : 0;
        statistics.to_review += open_concerns(result).empty() ? 0 : 1;
        statistics.overridden += result.review.overrides.empty() ? 0 : 1;
        statistics.printed += has_answers(result) ? 1 : 0;
    }
    for (auto& [outcome, who] : outcomes) statistics.outcomes.push_back({outcome, std::move(who)});
    summarise_points(statistics, graded);
    statistics.items = tally_items(graded);
    return statistics;
}

}  // namespace harness::report
