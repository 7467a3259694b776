// Where the parts of a picture are on its page.
#pragma once

#include "harness/report/picture/point.h"

namespace harness::report::picture {

inline constexpr double page_width = 560;
inline constexpr Box perspective_box{0, 22, 370, 290};
inline constexpr Box side_box{0, 318, 274, 538};
inline constexpr Box other_box{286, 318, 560, 538};
inline constexpr Box image_plane_box{386, 26, 556, 150};
inline constexpr Spot first_of_key{386, 190, 0};
inline constexpr double top_of_legend = 542;  ///< the notes follow it

}  // namespace harness::report::picture
