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

/// The nearest power of ten at or below the value, or at or above it.
double decade_below(double value);
double decade_above(double value);

}  // namespace harness::report
