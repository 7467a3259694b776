// Sorting the blocks lexicographically makes those that begin alike neighbours, and so yields a tree. A node is a range
// of blocks with the lines they all begin with. Whether to make the node's header depends only on the shorter header
// that the blocks would use otherwise, so the best choice is found from the leaves up.
#include "harness/build/header_plan.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>

namespace harness {
namespace {

/// The cost of making a header, relative to what it saves for one source: 2.9 to 3.8 over 20 blocks, measured with g++
/// 12.
constexpr double making = 3.5;
/// A smaller saving can't be measured.
constexpr double worthwhile_ms = 20;
/// The most lines of a block that count. Students have a dozen; of a longer block, the beginning can still be replaced.
constexpr std::size_t longest = 64;

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

HeaderLines beginning(const HeaderLines& lines, std::size_t count) {
    return {lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(count)};
}

struct Choice {
    double worth = 0;        ///< savings less costs, in milliseconds
    std::size_t length = 0;  ///< lines of the header in use from this node on; 0 for none
};

struct Node {
    std::size_t begin = 0, end = 0;  ///< in the sorted blocks
    std::size_t length = 0;          ///< number of lines they all begin with
    std::size_t whole = 0;           ///< how many of them are no longer than `length`
    std::size_t made = 0;            ///< length of the longest existing header that fits; 0 for none
    std::vector<Node> children;
    std::map<std::size_t, Choice> best;  ///< by the length of the header in use above
};

class Planner {
  public:
    Planner(std::vector<HeaderLines> sorted, const std::set<HeaderLines>& made)
        : blocks_(std::move(sorted)), made_(made), header_of_(blocks_.size(), 0) {}

    /// For each sorted block, how many of its lines a header replaces.
    std::vector<std::size_t> plan() {
        Node root = node(0, blocks_.size(), 0);
        best(root, 0);
        assign(root, 0);
        return header_of_;
    }

  private:
    Node node(std::size_t begin, std::size_t end, std::size_t from) {
        Node node;
        node.begin = begin;
        node.end = end;
        const HeaderLines& first = blocks_[begin];
        const HeaderLines& last = blocks_[end - 1];  // sorted, so lines that first and last share, all share
        std::size_t length = from;
        while (length < first.size() && length < last.size() && first[length] == last[length]) ++length;
        node.length = length;
        for (std::size_t made = length; made > from && node.made == 0; --made) {
            if (made_.contains(beginning(first, made))) node.made = made;
        }
        for (std::size_t i = begin; i < end;) {
            std::size_t next = i + 1;
            if (blocks_[i].size() == length) {
                ++node.whole;
            } else {
                while (next < end && blocks_[next].size() > length && blocks_[next][length] == blocks_[i][length])
                    ++next;
                node.children.push_back(this->node(i, next, length));
            }
            i = next;
        }
        return node;
    }

    double reading_time(const Node& node, std::size_t length) const {
        return length == 0 ? 0 : reading_time_ms(beginning(blocks_[node.begin], length));
    }

    double worth(Node& node, std::size_t length, double spent) {
        double worth = static_cast<double>(node.whole) * reading_time(node, length) - spent;
        for (Node& child : node.children) worth += best(child, length).worth;
        return worth;
    }

    const Choice& best(Node& node, std::size_t above) {
        const auto known = node.best.find(above);
        if (known != node.best.end()) return known->second;
        Choice best{worth(node, above, 0), above};
        const auto consider = [&](std::size_t length, double spent) {
            const double gain = worth(node, length, spent);
            if (gain > best.worth) best = {gain, length};
        };
        if (node.made > above) consider(node.made, 0);
        const double saved = reading_time(node, node.length);
        if (node.length > std::max(above, node.made) && saved >= worthwhile_ms) consider(node.length, making * saved);
        return node.best.emplace(above, best).first->second;
    }

    void assign(Node& node, std::size_t above) {
        const std::size_t length = best(node, above).length;
        std::fill(header_of_.begin() + static_cast<std::ptrdiff_t>(node.begin),
                  header_of_.begin() + static_cast<std::ptrdiff_t>(node.end), length);
        for (Node& child : node.children) assign(child, length);
    }

    std::vector<HeaderLines> blocks_;
    const std::set<HeaderLines>& made_;
    std::vector<std::size_t> header_of_;
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
    HeaderPlan plan;
    plan.header_of.resize(blocks.size());
    if (blocks.empty()) return plan;
    std::vector<std::size_t> order(blocks.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return blocks[a] < blocks[b]; });
    std::vector<HeaderLines> sorted;
    sorted.reserve(blocks.size());
    for (const std::size_t i : order) sorted.push_back(beginning(blocks[i], std::min(longest, blocks[i].size())));
    const std::vector<std::size_t> lengths = Planner(sorted, made).plan();

    std::map<HeaderLines, std::vector<std::size_t>> users;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (lengths[i] > 0) users[beginning(sorted[i], lengths[i])].push_back(order[i]);
    }
    std::vector<std::pair<HeaderLines, std::vector<std::size_t>>> headers(users.begin(), users.end());
    std::stable_sort(headers.begin(), headers.end(),
                     [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
    for (const auto& [lines, blocks_of] : headers) {
        for (const std::size_t block : blocks_of) plan.header_of[block] = plan.headers.size();
        plan.headers.push_back(lines);
    }
    return plan;
}

}  // namespace harness
