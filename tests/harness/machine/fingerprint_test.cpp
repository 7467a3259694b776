#include "harness/machine/fingerprint.h"

#include <gtest/gtest.h>

namespace {

using harness::Fingerprint;

TEST(Fingerprint, IsBlake2bOverTheFieldsWithTheirLengths) {
    // Python: hashlib.blake2b(b"1:p2:ab", digest_size=32).hexdigest()
    EXPECT_EQ(Fingerprint("p").add("ab").hex(), "37546c73856f79165c183f9a59c087433cae3837ac5a642d3c6cdf7ce8bd7066");
}

TEST(Fingerprint, KeepsFieldsApart) {
    EXPECT_NE(Fingerprint("p").add("ab").add("c").hex(), Fingerprint("p").add("a").add("bc").hex());
    EXPECT_NE(Fingerprint("p").add("").hex(), Fingerprint("p").hex());
    EXPECT_NE(Fingerprint("p").add("1:a").hex(), Fingerprint("p").add("a").hex());
    EXPECT_NE(Fingerprint("p").hex(), Fingerprint("q").hex());
}

TEST(Fingerprint, TakesNumbersAndNullBytes) {
    EXPECT_EQ(Fingerprint("p").add(-7).hex(), Fingerprint("p").add("-7").hex());
    EXPECT_NE(Fingerprint("p").add(std::string("a\0b", 3)).hex(), Fingerprint("p").add(std::string("a\0c", 3)).hex());
}

}  // namespace
