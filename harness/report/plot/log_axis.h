// A logarithmic scale from values to places in a picture, with a band at its low end for what a logarithm can't show.
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
    /// From `least` at `from` to `most` at `to`, in the picture's units, either way round. `band` is the width set
    /// aside before `least` for values below it, zero above all; 0 for none.
    LogAxis(double least, double most, double from, double to, double band = 0);

    /// Beyond the scale at its end; in the band's middle below `least`, where there is a band.
    double place(double value) const;
    bool is_in_band(double value) const { return band_ != 0 && value < least_; }
    double band_edge() const { return start_; }

    /// Powers of ten, labelled as far as they have room; where those are few also their two- and fivefold.
    std::vector<Tick> ticks() const;

  private:
    double least_;
    double most_;
    double from_;
    double to_;
    double start_;  ///< where `least` is
    double band_;
};

/// Two scales in a row: the second, beyond `bend`, packs what is far slower than most into little room.
class BentAxis {
  public:
    /// The values from `least` to `most` between `from` and `to`, `from` < `to`; bent where a few are far above the
    /// rest.
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

/// The power of ten at or below, or at or above.
double decade_below(double value);
double decade_above(double value);

}  // namespace harness::report
