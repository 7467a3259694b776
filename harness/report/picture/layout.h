// Where the parts of a picture stand on its page.
#pragma once

#include "harness/report/plot/label_placement.h"

namespace harness::report::picture {

inline constexpr double page_width = 560;
inline constexpr Box perspective_box{0, 22, 370, 290};
inline constexpr Box side_box{0, 318, 274, 538};
inline constexpr Box other_box{286, 318, 560, 538};
inline constexpr Box image_plane_box{386, 26, 556, 150};
inline constexpr Spot first_of_key{386, 190};
inline constexpr double first_note = 560;  ///< its baseline

}  // namespace harness::report::picture
