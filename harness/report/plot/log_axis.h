// A logarithmic scale from values to places in a picture, with a band at its low end for values that a logarithm can't
// show.
#pragma once

#include <string>
#include <vector>

namespace harness::report {

struct Tick {
    double place = 0;
    std::string label;  ///< empty for a mark without one
};

class LogAxis {
  public:
    /// Maps `least` to `from` and `most` to `to`, in the picture's units; `from` may be greater than `to`. `band` is
    /// the width before `least` that is set aside for lower values, mainly zero; 0 for no band.
    LogAxis(double least, double most, double from, double to, double band = 0);

    /// Values beyond the scale are placed at its end, values below `least` in the band's middle if there is a band.
    double place(double value) const;
    bool is_in_band(double value) const { return band_ != 0 && value < least_; }
    double band_edge() const { return start_; }

    /// Powers of ten, labelled if there is room; if they are few, also two and five times each.
    std::vector<Tick> ticks() const;

  private:
    double least_;
    double most_;
    double from_;
    double to_;
    double start_;  ///< where `least` is
    double band_;
};

/// Two scales in a row. The second, beyond `bend`, packs the values far above most others into little room.
class BentAxis {
  public:
    /// Maps `least` to `from` and `most` to `to`, with `from` < `to`. Bends if a few values are far above the rest.
    BentAxis(const std::vector<double>& values, double least, double most, double from, double to);

    double place(double value) const { return value > bend_ ? beyond_.place(value) : usual_.place(value); }
    std::vector<Tick> ticks() const;
    bool is_bent() const { return bend_ < most_; }
    /// Where the second scale begins.
    double bend_place() const { return usual_.place(bend_); }

  private:
    BentAxis(double least, double bend, double most, double from, double middle, double to);

    double bend_;
    double most_;
    LogAxis usual_;
    LogAxis beyond_;
};

/// The nearest power of ten at or below the value, or at or above it.
double decade_below(double value);
double decade_above(double value);

}  // namespace harness::report
