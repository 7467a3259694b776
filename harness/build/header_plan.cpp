// Which headers are best is the problem of where to build warehouses: it is NP-hard, and well solved by adding,
// dropping and exchanging one at a time for as long as that saves something.
#include "harness/build/header_plan.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace harness {
namespace {

/// The cost of making a header, relative to what it saves for one source: 2.9 to 3.8 over 20 blocks, measured with g++
/// 12.
constexpr double making = 3.5;
/// A smaller saving can't be measured.
constexpr double worthwhile_ms = 20;
/// How many of the most used blocks may get a header, and of how many of them every two are looked through for includes
/// that they have in common.
constexpr std::size_t most_blocks = 100;
constexpr std::size_t most_paired = 12;

struct Weight {
    std::string_view prefix;  ///< of the directive
    std::string_view family;  ///< headers that include much the same
    double first_ms;          ///< for the first of its family
    double next_ms;           ///< for each further one
};

/// Measured, g++ 12 -O1. The first prefix that fits counts.
constexpr Weight weights[] = {
    {"#define", "", 0, 0},
    {"#include <bits/stdc++.h>", "everything", 880, 0},
    {"#include <glm/vec", "glm vectors", 30, 5},
    {"#include <glm/gtx/string_cast.hpp>", "string_cast", 80, 0},
    {"#include \"glm/gtx/string_cast.hpp\"", "string_cast", 80, 0},
    {"#include <glm/ext.hpp>", "glm extensions", 150, 0},
    {"#include <glm/", "glm", 190, 8},
    {"#include \"glm/", "glm", 190, 8},
    {"#include <regex>", "regex", 200, 0},
    {"#include <iostream>", "streams", 160, 15},
    {"#include <fstream>", "streams", 165, 15},
    {"#include <sstream>", "streams", 165, 15},
    {"#include <iomanip>", "streams", 180, 30},
    {"#include <cmath>", "mathematics", 60, 0},
    {"#include <math.h>", "mathematics", 60, 0},
    {"#include <cstdlib>", "mathematics", 60, 0},
    {"#include <std", "C", 3, 3},
    {"#include <c", "C", 3, 3},
    {"#include", "containers", 60, 10},
};

bool is_part_of(const HeaderLines& some, const HeaderLines& all) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

/// Sources that include the same, with the same settings.
struct Alike {
    HeaderLines includes;
    std::vector<std::size_t> blocks;
};

struct Candidate {
    HeaderLines includes;
    double saves = 0;  ///< for each source that it fits, in milliseconds
    double costs = 0;
    std::vector<bool> fits;  ///< for each kind of sources
};

/// Plans for sources of the same settings.
class Planner {
  public:
    /// `alike`: the most used first. `made`: the includes of headers that exist.
    Planner(const std::vector<Alike>& alike, const std::set<HeaderLines>& made) : alike_(alike) {
        std::set<HeaderLines> considered = made;
        for (std::size_t i = 0; i < std::min(alike.size(), most_blocks); ++i) {
            considered.insert(alike[i].includes);
            for (std::size_t j = 0; j < std::min(i, most_paired); ++j) considered.insert(shared(alike[i], alike[j]));
        }
        for (const HeaderLines& includes : considered) {
            const double saves = reading_time_ms(includes);
            const bool exists = made.contains(includes);
            if (!exists && saves < worthwhile_ms) continue;
            Candidate candidate{includes, saves, exists ? 0 : making * saves, {}};
            for (const Alike& kind : alike) candidate.fits.push_back(is_part_of(includes, kind.includes));
            candidates_.push_back(std::move(candidate));
        }
    }

    /// For each kind of sources, the includes of its header.
    std::vector<HeaderLines> plan() {
        while (improve()) {
        }
        std::vector<HeaderLines> header_of;
        for (std::size_t kind = 0; kind < alike_.size(); ++kind) {
            const Candidate* best = nullptr;
            for (const std::size_t i : chosen_) {
                const Candidate& candidate = candidates_[i];
                if (candidate.fits[kind] && (best == nullptr || candidate.saves > best->saves)) best = &candidate;
            }
            header_of.push_back(best != nullptr ? best->includes : HeaderLines());
        }
        return header_of;
    }

  private:
    static HeaderLines shared(const Alike& one, const Alike& other) {
        HeaderLines both;
        std::set_intersection(one.includes.begin(), one.includes.end(), other.includes.begin(), other.includes.end(),
                              std::back_inserter(both));
        return both;
    }

    /// What each kind's header saves for one source, where these headers are made.
    std::vector<double> savings(const std::set<std::size_t>& headers) const {
        std::vector<double> saved(alike_.size(), 0);
        for (const std::size_t i : headers) {
            for (std::size_t kind = 0; kind < saved.size(); ++kind) {
                if (candidates_[i].fits[kind]) saved[kind] = std::max(saved[kind], candidates_[i].saves);
            }
        }
        return saved;
    }

    double worth(const std::set<std::size_t>& headers, const std::vector<double>& saved) const {
        double worth = 0;
        for (std::size_t kind = 0; kind < saved.size(); ++kind)
            worth += saved[kind] * static_cast<double>(alike_[kind].blocks.size());
        for (const std::size_t i : headers) worth -= candidates_[i].costs;
        return worth;
    }

    /// What one more header is worth where `saved` is saved without it.
    double gain(const Candidate& more, const std::vector<double>& saved) const {
        double gain = -more.costs;
        for (std::size_t kind = 0; kind < saved.size(); ++kind) {
            if (more.fits[kind] && more.saves > saved[kind])
                gain += (more.saves - saved[kind]) * static_cast<double>(alike_[kind].blocks.size());
        }
        return gain;
    }

    /// Takes the change of one header that is worth the most. Returns false if none is worth anything.
    bool improve() {
        constexpr double noticeable = 1e-6;
        double best = worth(chosen_, savings(chosen_)) + noticeable;
        std::optional<std::set<std::size_t>> better;
        const auto consider = [&](std::set<std::size_t> headers) {
            const std::vector<double> saved = savings(headers);
            const double without = worth(headers, saved);
            if (without > best) {
                best = without;
                better = headers;
            }
            for (std::size_t i = 0; i < candidates_.size(); ++i) {
                const double with = without + gain(candidates_[i], saved);
                if (with <= best) continue;
                best = with;
                better = headers;
                better->insert(i);
            }
        };
        consider(chosen_);
        for (const std::size_t i : chosen_) {
            std::set<std::size_t> fewer = chosen_;
            fewer.erase(i);
            consider(std::move(fewer));
        }
        if (better) chosen_ = std::move(*better);
        return better.has_value();
    }

    const std::vector<Alike>& alike_;
    std::vector<Candidate> candidates_;
    std::set<std::size_t> chosen_;
};

}  // namespace

double reading_time_ms(const HeaderLines& lines) {
    double time = 0;
    std::set<std::string_view> seen;
    for (const std::string& line : lines) {
        const auto* const weight = std::find_if(std::begin(weights), std::end(weights), [&](const Weight& candidate) {
            return line.compare(0, candidate.prefix.size(), candidate.prefix) == 0;
        });
        if (weight == std::end(weights)) continue;
        time += seen.insert(weight->family).second ? weight->first_ms : weight->next_ms;
    }
    return time;
}

HeaderPlan plan_headers(const std::vector<HeaderLines>& blocks, const std::set<HeaderLines>& made) {
    // By settings, then by includes.
    std::map<HeaderLines, std::map<HeaderLines, Alike>> sources;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        HeaderParts parts = header_parts(blocks[i]);
        Alike& alike = sources[parts.settings][parts.includes];
        alike.includes = std::move(parts.includes);
        alike.blocks.push_back(i);
    }
    std::map<HeaderLines, std::vector<std::size_t>> users;
    for (const auto& [settings, by_includes] : sources) {
        std::set<HeaderLines> made_includes;
        for (const HeaderLines& lines : made) {
            HeaderParts parts = header_parts(lines);
            if (parts.settings == settings && lines_of(parts) == lines) made_includes.insert(std::move(parts.includes));
        }
        std::vector<Alike> alike;
        for (const auto& [includes, kind] : by_includes) alike.push_back(kind);
        std::stable_sort(alike.begin(), alike.end(),
                         [](const Alike& a, const Alike& b) { return a.blocks.size() > b.blocks.size(); });
        const std::vector<HeaderLines> header_of = Planner(alike, made_includes).plan();
        for (std::size_t kind = 0; kind < alike.size(); ++kind) {
            if (header_of[kind].empty()) continue;
            std::vector<std::size_t>& of_header = users[lines_of({settings, header_of[kind]})];
            of_header.insert(of_header.end(), alike[kind].blocks.begin(), alike[kind].blocks.end());
        }
    }
    std::vector<std::pair<HeaderLines, std::vector<std::size_t>>> headers(users.begin(), users.end());
    std::stable_sort(headers.begin(), headers.end(),
                     [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
    HeaderPlan plan;
    plan.header_of.resize(blocks.size());
    for (const auto& [lines, blocks_of] : headers) {
        for (const std::size_t block : blocks_of) plan.header_of[block] = plan.headers.size();
        plan.headers.push_back(lines);
    }
    return plan;
}

}  // namespace harness
