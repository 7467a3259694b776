// How a class is split.
#include "harness/shards/shard.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

namespace harness {
namespace {

Submission submission(const std::string& id, const std::string& source) {
    Submission one;
    one.id = id;
    one.source = source;
    return one;
}

/// Programs that use one of `kinds` precompiled headers each; those with <cstdio> use none.
std::vector<Submission> programs(int count, int kinds) {
    const std::vector<std::string> headers{"<cstdio>", "<glm/glm.hpp>", "<bits/stdc++.h>", "<iostream>"};
    std::vector<Submission> submissions;
    for (int i = 0; i < count; ++i) {
        const std::string header = headers[static_cast<std::size_t>(i % kinds)];
        submissions.push_back(submission("s" + std::to_string(i),
                                         "#include " + header + "\nint main() { return " + std::to_string(i) + "; }"));
    }
    return submissions;
}

TEST(Split, GivesEachSubmissionOneShardOfNearlyTheSameSize) {
    for (const int count : {1, 2, 3, 7, 16}) {
        std::map<int, int> sizes;
        for (const int shard : split(programs(200, 4), count)) ++sizes[shard];
        ASSERT_EQ(sizes.size(), static_cast<std::size_t>(count));
        EXPECT_EQ(sizes.begin()->first, 1);
        EXPECT_EQ(sizes.rbegin()->first, count);
        for (const auto& [shard, size] : sizes) {
            EXPECT_GE(size, 200 / count) << shard << " of " << count;
            EXPECT_LE(size, 200 / count + 1) << shard << " of " << count;
        }
    }
}

TEST(Split, DependsNeitherOnNamesNorOnTheOrder) {
    const auto class_ = programs(50, 3);
    const auto shards = split(class_, 4);
    auto reversed = class_;
    std::reverse(reversed.begin(), reversed.end());
    for (Submission& each : reversed) each.id += "'s";
    auto expected = shards;
    std::reverse(expected.begin(), expected.end());
    EXPECT_EQ(split(reversed, 4), expected);
}

TEST(Split, KeepsEqualSourcesTogether) {
    auto class_ = programs(10, 2);
    for (int i = 0; i < 10; ++i) class_.push_back(submission("copy" + std::to_string(i), class_[3].source));
    for (const int count : {2, 5, 20}) {
        const auto shards = split(class_, count);
        for (std::size_t i = 10; i < class_.size(); ++i) EXPECT_EQ(shards[i], shards[3]);
    }
}

TEST(Split, GivesAPrecompiledHeaderToFewShards) {
    const auto class_ = programs(400, 4);
    const auto shards = split(class_, 16);
    for (std::size_t kind = 0; kind < 4; ++kind) {
        std::set<int> of_kind;
        for (std::size_t i = kind; i < class_.size(); i += 4) of_kind.insert(shards[i]);
        EXPECT_LE(of_kind.size(), 5U) << "four full ones, or three and two with a rest";
    }
}

TEST(Split, PutsSubmissionsWithoutASourceIntoAShardToo) {
    auto class_ = programs(3, 1);
    class_.push_back(submission("none", ""));
    class_.back().problem = "holds no source";
    const int shard = split(class_, 2).back();
    EXPECT_GE(shard, 1);
    EXPECT_LE(shard, 2);
    std::rotate(class_.begin(), class_.begin() + 3, class_.end());
    EXPECT_EQ(split(class_, 2).front(), shard);
    EXPECT_TRUE(split({}, 3).empty());
}

TEST(ReadShard, ReadsANumberAndACount) {
    const auto shard = read_shard("3/16");
    ASSERT_TRUE(shard);
    EXPECT_EQ(shard->number, 3);
    EXPECT_EQ(shard->count, 16);
    for (const char* wrong : {"", "3", "/", "3/", "/3", "4/3", "0/3", "1/0", "-1/3", "+1/3", " 1/3", "1/3 ", "1/3/3",
                              "1/10001", "1/99999999999999999999", "a/b"})
        EXPECT_FALSE(read_shard(wrong)) << wrong;
}

}  // namespace
}  // namespace harness
