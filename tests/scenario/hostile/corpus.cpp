#include "tests/scenario/hostile/corpus.h"

#include <algorithm>
#include <fstream>
#include <string_view>

namespace hostile {
namespace {

constexpr std::string_view start = "// Tries: ";
constexpr std::string_view middle = ". Outcome: ";
constexpr std::string_view choice = " or ";

Attack read_attack(const std::filesystem::path& folder) {
    Attack attack{folder.filename(), folder, {}, {}};
    std::string line;
    std::getline(std::ifstream(folder / "ray_cast.cpp"), line);
    const std::size_t at = line.rfind(middle);
    if (!line.starts_with(start) || at == std::string::npos || !line.ends_with('.')) return attack;
    attack.tries = line.substr(start.size(), at - start.size());
    std::string rest = line.substr(at + middle.size());
    rest.pop_back();
    for (std::size_t end = 0; end != std::string::npos;) {
        end = rest.find(choice);
        attack.outcomes.push_back(rest.substr(0, end));
        if (end != std::string::npos) rest.erase(0, end + choice.size());
    }
    return attack;
}

}  // namespace

std::vector<Attack> read_corpus(const std::filesystem::path& folder) {
    std::vector<Attack> corpus;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) corpus.push_back(read_attack(entry.path()));
    std::sort(corpus.begin(), corpus.end(), [](const Attack& a, const Attack& b) { return a.name < b.name; });
    return corpus;
}

}  // namespace hostile
