#include "reference/render/scene/huge_pages.h"

#include <gtest/gtest.h>

#include <cstdint>

using namespace reference::render;

namespace {

struct alignas(64) Aligned {
    std::uint64_t number;
};

bool begins_a_page(const void* array) {
    return reinterpret_cast<std::uintptr_t>(array) % HugePages<Aligned>::page == 0;
}

TEST(HugePages, BeginWithLargeArrays) {
    EXPECT_TRUE(begins_a_page(InHugePages<Aligned>(HugePages<Aligned>::page / sizeof(Aligned)).data()));
}

TEST(HugePages, KeepWhatAnArrayHoldsWhileItGrows) {
    InHugePages<Aligned> array;
    for (std::uint64_t i = 0; i < 200'000; ++i) {
        array.push_back({i});
        ASSERT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % alignof(Aligned), 0U);
    }
    const InHugePages<Aligned> copy = array;
    array = {};
    for (std::uint64_t i = 0; i < copy.size(); ++i) ASSERT_EQ(copy[i].number, i);
}

}  // namespace
