// Replays the fuzzers' corpora without a fuzzer: every property on every file, unchanged and with seeded random
// changes. Most useful in the build with sanitizers.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/properties.h"
#include "tests/given/bytes_of.h"

namespace {

namespace fs = std::filesystem;

struct Target {
    std::string name;  ///< of its folder in corpus/
    std::string (*check)(std::string_view);
    int trials;                        ///< with random changes
    std::vector<std::string> also{};   ///< folders with further inputs
    std::vector<std::string> names{};  ///< of the files there that count; all if empty

    friend std::ostream& operator<<(std::ostream& out, const Target& target) { return out << target.name; }
};

std::vector<Target> targets() {
    return {{"archive", check_archive, 800},
            {"csv", check_csv, 800},
            {"http", check_http, 800},
            {"lms_name", check_lms_name, 800},
            {"metadata", check_metadata, 800},
            {"source", check_source, 250, {"submissions"}, {"ray_cast.cpp"}},
            {"toml", check_toml, 800, {"reference/assignments", "reference/scenes"}},
            {"transcript",
             check_transcript,
             250,
             {"tests/given/transcripts", "submissions"},
             {"output.txt", "expected_stdout.txt"}}};
}

/// The inputs of a target, sorted by path, so that a seed means the same on every machine.
std::vector<fs::path> inputs(const Target& target) {
    const fs::path project = RAYGRADE_PROJECT;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(project / "tests/fuzz/corpus" / target.name))
        files.push_back(entry.path());
    for (const std::string& folder : target.also) {
        for (const auto& entry : fs::recursive_directory_iterator(project / folder)) {
            const auto& names = target.names;
            const bool counts =
                names.empty() || std::find(names.begin(), names.end(), entry.path().filename()) != names.end();
            if (entry.is_regular_file() && counts) files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t bound) {
    return bound == 0 ? 0 : random() % bound;
}

/// One small change: sets, removes or doubles bytes, or inserts a piece of a different input.
void change(std::string& text, const std::string& other, Random& random) {
    constexpr std::string_view signs = "()[]{}<>|=:,;.-+*/^'\"\n\t\r\x1b 0123456789eE_tuvxyzQ#\xe2\x88\x92\xff";
    const std::size_t at = below(random, text.size() + 1);
    const std::size_t length = below(random, 40);
    switch (random() % 5) {
        case 0: text.insert(at, 1, signs[below(random, signs.size())]); break;
        case 1: text.erase(at, length); break;
        case 2: text.insert(at, text.substr(below(random, text.size() + 1), length)); break;
        case 3: text.insert(at, other.substr(below(random, other.size() + 1), length)); break;
        default:
            if (at < text.size()) text[at] = static_cast<char>(random() & 0xFFU);
    }
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, KeepsEveryProperty) {
    const std::vector<fs::path> files = inputs(GetParam());
    ASSERT_FALSE(files.empty());
    for (const fs::path& file : files) EXPECT_EQ(GetParam().check(bytes_of(file)), "") << file;
}

TEST_P(Corpus, KeepsEveryPropertyWithRandomChanges) {
    constexpr std::uint64_t seed = 20211101;
    Random random(seed);
    std::vector<std::string> texts;
    for (const fs::path& file : inputs(GetParam())) texts.push_back(bytes_of(file));
    ASSERT_FALSE(texts.empty());
    for (int trial = 0; trial < GetParam().trials; ++trial) {
        std::string text = texts[below(random, texts.size())];
        const std::string& other = texts[below(random, texts.size())];
        for (std::size_t changes = 1 + below(random, 12); changes > 0; --changes) change(text, other, random);
        ASSERT_EQ(GetParam().check(text), "") << "seed " << seed << ", trial " << trial << ":\n"
                                              << testing::PrintToString(text);
    }
}

INSTANTIATE_TEST_SUITE_P(OfEach, Corpus, testing::ValuesIn(targets()),
                         [](const testing::TestParamInfo<Target>& one) { return one.param.name; });

}  // namespace
