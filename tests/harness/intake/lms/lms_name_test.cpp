#include "harness/intake/lms/lms_name.h"

#include <gtest/gtest.h>

namespace {

TEST(CanvasName, IsReadInEightShapes) {
    using harness::read_canvas_name;
    const auto plain = read_canvas_name("doejane_123_456_ray_cast.cpp");
    ASSERT_TRUE(plain);
    EXPECT_EQ(plain->student, "doejane");
    EXPECT_EQ(plain->id, "123");
    EXPECT_EQ(plain->attachment, "456");
    EXPECT_EQ(plain->file, "ray_cast.cpp");
    EXPECT_EQ(plain->late, false);
    EXPECT_EQ(read_canvas_name("doejane_LATE_123_456_ray_cast.cpp")->late, true);
    EXPECT_EQ(read_canvas_name("doejane_123_456_1_2_3.cpp")->file, "1_2_3.cpp") << "digits in the file's name";
    EXPECT_EQ(read_canvas_name("anon_9_456_ray_cast.cpp")->id, "anon_9");
    EXPECT_EQ(read_canvas_name("LATE_anon_9_456_ray_cast.cpp")->late, true);
    EXPECT_FALSE(read_canvas_name("doejane_123_text.html")->is_file);
    EXPECT_FALSE(read_canvas_name("anon_9_link.html")->is_file);
    EXPECT_EQ(read_canvas_name("группа_LATE_7_8_a b.cpp")->student, "группа");
    for (const char* other : {"ray_cast.cpp", "doejane_ray_cast.cpp", "doejane_123_ray_cast.cpp", "s01.cpp"})
        EXPECT_FALSE(read_canvas_name(other)) << other;
}

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
