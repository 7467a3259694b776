#include "tests/given/report/helvetica.h"

#include <gtest/gtest.h>

#include <array>

namespace drawn {
namespace {

/// Letter widths from Adobe's Helvetica.afm, in thousandths of the font size, from the blank to the tilde.
constexpr std::array<int, 95> advances = {
    278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,  //
    556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,  //
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,  //
    667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,  //
    333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,  //
    556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};

}  // namespace

double helvetica_width(std::string_view text, double font_size) {
    int thousandths = 0;
    for (const char c : text) {
        if (c < ' ' || c > '~') {
            ADD_FAILURE() << "no width is known of a letter in " << text;
            continue;
        }
        thousandths += advances[static_cast<std::size_t>(c - ' ')];
    }
    return thousandths * font_size / 1000;
}

}  // namespace drawn
