#include "tests/given/golden.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

testing::AssertionResult is_golden(const std::string& text, const std::string& file) {
    const std::string path = RAYGRADE_PROJECT "/tests/given/golden/" + file;
    if (std::getenv("RAYGRADE_UPDATE_GOLDEN") != nullptr) {
        std::ofstream(path) << text;
        return testing::AssertionSuccess();
    }
    std::ifstream golden(path);
    if (!golden) return testing::AssertionFailure() << "cannot read " << path;
    std::istringstream lines(text);
    for (int number = 1;; ++number) {
        std::string expected;
        std::string line;
        const bool more_expected = static_cast<bool>(std::getline(golden, expected));
        const bool more = static_cast<bool>(std::getline(lines, line));
        if (!more_expected && !more) return testing::AssertionSuccess();
        if (more_expected == more && expected == line) continue;
        return testing::AssertionFailure() << file << ":" << number << " is\n  " << (more ? line : "(no line)")
                                           << "\nand not\n  " << (more_expected ? expected : "(no line)")
                                           << "\nRAYGRADE_UPDATE_GOLDEN=1 accepts all changes of the reports.";
    }
}

std::string bare(std::string page) {
    for (const auto& [begin, end] :
         {std::pair<std::string, std::string>("<style>", "</style>"), {"<script>", "</script>"}, {"<svg ", "</svg>"}}) {
        for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
            const std::size_t from = page.find('>', at) + 1;
            page.erase(from, page.find(end, from) - from);
        }
    }
    return page;
}
