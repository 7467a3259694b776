#include "harness/intake/lms/lms_name.h"

#include <gtest/gtest.h>

namespace {

TEST(BaseName, OmitsTheNumberOfARepeatedSubmission) {
    using harness::read_base_name;
    EXPECT_EQ(read_base_name("ray_cast-12.cpp").name, "ray_cast.cpp");
    EXPECT_EQ(read_base_name("ray_cast-12.cpp").turn, 12);
    EXPECT_EQ(read_base_name("ray_cast (3).cpp").name, "ray_cast.cpp");
    EXPECT_EQ(read_base_name("ray_cast(3).cpp").turn, 3);
    EXPECT_EQ(read_base_name("ray_cast.cpp").turn, 0);
    EXPECT_EQ(read_base_name("-1.cpp").name, "-1.cpp");
    EXPECT_EQ(read_base_name("ray-99999999999999999999.cpp").turn, 0) << "no number of turns";
}

}  // namespace
