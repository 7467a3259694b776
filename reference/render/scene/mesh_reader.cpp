#include "reference/render/scene/mesh_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "reference/toml/assignment_error.h"

namespace reference::render {
namespace {

constexpr double largest_coordinate = 1e30;
constexpr std::size_t most_quoted = 40;

/// The next word of the line, which is taken from it; empty at its end.
std::string_view take_word(std::string_view& line) {
    constexpr std::string_view blanks = " \t\r";
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line.remove_prefix(word.size());
    return word;
}

/// Empty unless the whole word is a number, or one followed by a slash for an index.
template <class Number>
std::optional<Number> number_of(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    if constexpr (std::is_same_v<Number, long>) word = word.substr(0, word.find('/'));
    Number x = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
    if (word.empty() || error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return x;
}

struct Reading {
    const std::string& name;
    std::vector<Vec3<double>> vertices = {};
    std::vector<Triangle<double>> triangles = {};
    std::size_t faces = 0;

    template <class... Parts>
    [[noreturn]] void refuse(fmt::format_string<Parts...> mistake, Parts&&... parts) const {
        throw AssignmentError(name + ": " + fmt::format(mistake, std::forward<Parts>(parts)...));
    }

    void add_vertex(std::string_view line) {
        const std::size_t count = vertices.size() + 1;
        const auto coordinate = [&] {
            const std::string_view word = take_word(line);
            if (word.empty()) refuse("vertex {} has fewer than three coordinates", count);
            const std::optional<double> x = number_of<double>(word);
            if (!x) refuse("vertex {}: \"{}\" is not a number that a double holds", count, word.substr(0, most_quoted));
            if (!(std::abs(*x) <= largest_coordinate)) {
                refuse("vertex {} has a coordinate beyond 1e30; scale the mesh", count);
            }
            return *x;
        };
        const double x = coordinate();
        const double y = coordinate();
        vertices.emplace_back(x, y, coordinate());
    }

    /// OBJ counts vertices from 1, or from -1 backwards from the last one so far.
    const Vec3<double>& vertex(std::string_view word) const {
        const std::optional<long> index = number_of<long>(word);
        if (!index) refuse("face {}: \"{}\" is not a vertex's number", faces, word.substr(0, most_quoted));
        const auto count = static_cast<long>(vertices.size());
        if (*index == 0 || *index > count || *index < -count) {
            refuse("face {} names vertex {}, and {} vertices come before it", faces, *index, count);
        }
        return vertices[static_cast<std::size_t>(*index < 0 ? count + *index : *index - 1)];
    }

    void add_face(std::string_view line) {
        ++faces;
        std::vector<Vec3<double>> corners;
        for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
            corners.push_back(vertex(word));
            if (triangles.size() + corners.size() > most_triangles + 2) {
                refuse("holds more than {} triangles; simplify the mesh", most_triangles);
            }
        }
        if (corners.size() < 3) refuse("face {} has {} vertices; a face has three or more", faces, corners.size());
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            triangles.push_back({corners[0], corners[i], corners[i + 1]});
        }
    }
};

}  // namespace

std::vector<Triangle<double>> read_mesh(std::istream& obj, const std::string& name) {
    Reading reading{name};
    for (std::string text; std::getline(obj, text);) {
        std::string_view line = text;
        const std::string_view keyword = take_word(line);
        if (keyword == "v") reading.add_vertex(line);
        if (keyword == "f") reading.add_face(line);
    }
    if (reading.triangles.empty()) reading.refuse("holds no faces; is it a Wavefront OBJ file?");
    return std::move(reading.triangles);
}

std::vector<Triangle<double>> load_mesh(const MeshFile& mesh) {
    const std::string name = fmt::format("{}: {}", mesh.place, mesh.path.string());
    std::error_code error;
    if (!std::filesystem::is_regular_file(mesh.path, error)) {
        throw AssignmentError(fmt::format("{}: no such file; a mesh is named from its scene's folder", name));
    }
    if (std::filesystem::file_size(mesh.path, error) > largest_mesh_file_bytes) {
        throw AssignmentError(
            fmt::format("{}: larger than {} MiB; simplify the mesh", name, largest_mesh_file_bytes >> 20U));
    }
    std::ifstream file(mesh.path, std::ios::binary);
    if (!file) throw AssignmentError(fmt::format("{}: can't be read; check its permissions", name));
    return read_mesh(file, name);
}

}  // namespace reference::render
