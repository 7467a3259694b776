#include "harness/report/plot/scatter_layout.h"

#include <algorithm>
#include <cmath>

#include "harness/text/markup.h"

namespace harness::report {
namespace {

constexpr double width = 480;
constexpr double left = 58;
constexpr double right = width - 14;
constexpr double top = 44;
constexpr double below = 52;  ///< for the axis across
constexpr double line_in_band = 18;
constexpr double least_band = 46;

std::vector<std::size_t> in_band(const Scatter& scatter) {
    std::vector<std::size_t> points;
    if (scatter.band_title.empty()) return points;
    for (std::size_t i = 0; i < scatter.points.size(); ++i) {
        if (scatter.points[i].y < scatter.least) points.push_back(i);
    }
    std::stable_sort(points.begin(), points.end(), [&](std::size_t one, std::size_t other) {
        return scatter.points[one].x < scatter.points[other].x;
    });
    return points;
}

BentAxis time_axis(const Scatter& scatter) {
    double least = HUGE_VAL;
    double most = 0;
    std::vector<double> times;
    for (const ScatterPoint& point : scatter.points) {
        times.push_back(point.x);
        least = std::min({least, point.x, point.x_low});
        most = std::max({most, point.x, point.x_high});
    }
    if (!(least > 0 && least <= most)) least = most = 1;
    constexpr double margin = 1.25;
    constexpr double least_range = 6;
    const double widen = std::max(margin, std::sqrt(least_range * least / most));
    return {times, least / widen, most * widen, left + 8, right - 8};
}

double end_of_scale(const Scatter& scatter) {
    double most = std::max(scatter.most, 10 * scatter.least);
    for (const ScatterPoint& point : scatter.points) {
        for (const double y : {point.y, point.y_high}) {
            if (std::isfinite(y)) most = std::max(most, y);
        }
    }
    most = decade_above(most);
    return scatter.ceiling ? std::min(most, *scatter.ceiling) : most;
}

Frame frame_for(const Scatter& scatter, std::size_t points_in_band, double more_height) {
    constexpr double scale = 280;
    constexpr double scale_without_points = 80;
    const bool any_above = points_in_band < scatter.points.size();
    const double band =
        scatter.band_title.empty() ? 0 : std::max(least_band, line_in_band * (static_cast<double>(points_in_band) + 1));
    const double bottom = top + (any_above ? scale + more_height : scale_without_points) + band;
    return {width,
            bottom + below,
            left,
            right,
            top,
            bottom,
            band,
            time_axis(scatter),
            LogAxis(scatter.least, end_of_scale(scatter), bottom, top, band)};
}

std::vector<Spot> spots_in(const Frame& frame, const Scatter& scatter, const std::vector<std::size_t>& lines) {
    std::vector<Spot> spots;
    for (const ScatterPoint& point : scatter.points) spots.push_back({frame.x.place(point.x), frame.y.place(point.y)});
    const double step = frame.band / (static_cast<double>(lines.size()) + 1);
    for (std::size_t i = 0; i < lines.size(); ++i)
        spots[lines[i]].y = frame.band_top() + step * (static_cast<double>(i) + 1);
    return spots;
}

/// Leaves out the part of an interval that is in the band, where heights mean nothing.
std::vector<Segment> bars_of(const ScatterPoint& point, const Spot& spot, const Frame& frame) {
    std::vector<Segment> bars;
    if (point.x_low < point.x_high)
        bars.push_back({{frame.x.place(point.x_low), spot.y}, {frame.x.place(point.x_high), spot.y}});
    if (point.y_low < point.y_high && !frame.y.is_in_band(point.y_high)) {
        const double low = frame.y.is_in_band(point.y_low) ? frame.y.band_edge() : frame.y.place(point.y_low);
        bars.push_back({{spot.x, low}, {spot.x, frame.y.place(point.y_high)}});
    }
    return bars;
}

/// The steps go from the top down to the fastest method, then to each slower but better one, then to the right edge,
/// unless the last is in the band, where nothing can be better.
std::vector<Segment> frontier_of(const Scatter& scatter, const std::vector<Spot>& spots, const Frame& frame) {
    std::vector<std::size_t> best;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        if (scatter.points[i].on_frontier) best.push_back(i);
    }
    std::stable_sort(best.begin(), best.end(), [&](std::size_t one, std::size_t other) {
        return scatter.points[one].x < scatter.points[other].x;
    });
    std::vector<Segment> steps;
    double y = frame.top;
    for (const std::size_t i : best) {
        if (!steps.empty()) steps.push_back({steps.back().to, {spots[i].x, y}});
        steps.push_back({{spots[i].x, y}, spots[i]});
        y = spots[i].y;
    }
    if (!steps.empty() && y <= frame.band_top()) steps.push_back({steps.back().to, {frame.right, y}});
    return steps;
}

}  // namespace

Layout lay_out(const Scatter& scatter) {
    constexpr double growth = 60;
    constexpr int most_growths = 20;
    constexpr double bold = 1.07;  // a bold name is so much wider
    const std::vector<std::size_t> lines = in_band(scatter);
    for (int i = 0;; ++i) {
        Layout layout{frame_for(scatter, lines.size(), i * growth), {}, {}, {}, {}};
        const Frame& frame = layout.frame;
        layout.spots = spots_in(frame, scatter, lines);
        layout.frontier = frontier_of(scatter, layout.spots, frame);
        std::vector<Segment> drawn = layout.frontier;
        std::vector<Label> labels;
        for (std::size_t j = 0; j < layout.spots.size(); ++j) {
            const ScatterPoint& point = scatter.points[j];
            if (point.is_named) {
                labels.push_back(
                    {layout.spots[j], text_width(point.name, name_size) * (point.on_frontier ? bold : 1), name_height});
            }
            layout.bars.push_back(bars_of(point, layout.spots[j], frame));
            drawn.insert(drawn.end(), layout.bars.back().begin(), layout.bars.back().end());
        }
        Placement placement =
            place_labels(labels, {frame.left + 2, frame.top + 2, frame.right - 2, frame.bottom - 1}, drawn);
        layout.names = std::move(placement.boxes);
        if (placement.is_clear || i == most_growths) return layout;
    }
}

}  // namespace harness::report
