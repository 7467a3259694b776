// sRGB's curve between amounts of light and what pictures store, from 0 to 1: IEC 61966-2-1. By products and sums
// alone, as std::pow differs between machines.
#pragma once

namespace reference::render {

/// x from 0.001 to 1. Newton's method from above.
inline double fifth_root(double x) {
    double root = 1;
    for (int i = 0; i < 40; ++i) root = (4 * root + x / (root * root * root * root)) / 5;
    return root;
}

/// The amount of light that `stored` stands for.
inline double light_of_srgb(double stored) {
    if (stored <= 0.04045) return stored / 12.92;
    const double base = (stored + 0.055) / 1.055;
    const double square = base * base;
    // base^2.4
    return square * fifth_root(square);
}

}  // namespace reference::render
