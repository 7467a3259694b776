// Replays the fuzzer's corpus without the fuzzer: reads and matches every corpus file, golden transcript and labelled
// output, unchanged and with seeded random changes. Most useful in the build with sanitizers.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/transcript_properties.h"
#include "tests/given/bytes_of.h"

namespace {

namespace fs = std::filesystem;

/// The corpus, sorted by path, so that a seed means the same on every machine.
std::vector<fs::path> corpus() {
    const fs::path project = RAYGRADE_PROJECT;
    std::vector<fs::path> files;
    for (const char* folder : {"tests/fuzz/transcript_corpus", "tests/given/transcripts", "submissions"}) {
        for (const auto& entry : fs::recursive_directory_iterator(project / folder)) {
            const std::string name = entry.path().filename();
            const bool output = name == "output.txt" || name == "expected_stdout.txt";
            const bool crafted = entry.path().parent_path().filename() == "transcript_corpus";
            if (entry.is_regular_file() && (output || crafted)) files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t bound) {
    return bound == 0 ? 0 : random() % bound;
}

/// One small change: sets, removes or doubles bytes, or inserts a piece of a different output.
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

TEST(TranscriptCorpus, IsReadUnchanged) {
    for (const fs::path& file : corpus()) EXPECT_EQ(check_transcript(bytes_of(file)), "") << file;
}

TEST(TranscriptCorpus, IsReadWithTwoThousandRandomChanges) {
    constexpr std::uint64_t seed = 20211101;
    constexpr int trials = 2000;
    Random random(seed);
    std::vector<std::string> texts;
    for (const fs::path& file : corpus()) texts.push_back(bytes_of(file));
    ASSERT_FALSE(texts.empty());
    for (int trial = 0; trial < trials; ++trial) {
        std::string text = texts[below(random, texts.size())];
        const std::string& other = texts[below(random, texts.size())];
        for (std::size_t changes = 1 + below(random, 12); changes > 0; --changes) change(text, other, random);
        ASSERT_EQ(check_transcript(text), "") << "seed " << seed << ", trial " << trial << ":\n"
                                              << testing::PrintToString(text);
    }
}

}  // namespace
