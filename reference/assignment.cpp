#include "reference/assignment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "reference/toml_table.h"

namespace reference {
namespace {

/// Rays that start this many pixels apart are one picture; keeps W and H inside exact float and int arithmetic.
constexpr int most_pixels_per_side = 1 << 30;

Vec3<Decimal> read_vector(const TomlTable& table, std::string_view key) {
    const std::vector<Decimal> numbers = table.decimals(key, 3);
    return {numbers[0], numbers[1], numbers[2]};
}

Camera<Decimal> read_camera(const TomlTable& table) {
    table.allow_only({"eye", "lookat", "vup"});
    return {read_vector(table, "eye"), read_vector(table, "lookat"), read_vector(table, "vup")};
}

Window<Decimal> read_window(const TomlTable& table) {
    table.allow_only({"clip_left", "clip_right", "clip_bottom", "clip_top", "clip_near", "width", "height", "pixel"});
    Window<Decimal> window{table.decimal("clip_left"),
                           table.decimal("clip_right"),
                           table.decimal("clip_bottom"),
                           table.decimal("clip_top"),
                           table.decimal("clip_near"),
                           table.integer("width", 1, most_pixels_per_side),
                           table.integer("height", 1, most_pixels_per_side)};
    if (window.clip_near.sign() <= 0) {
        table.fail("clip_near", "must be above 0: the image plane lies before the eye");
    }
    return window;
}

Pixel read_pixel(const TomlTable& table, const Window<Decimal>& window) {
    const std::vector<Decimal> numbers = table.decimals("pixel", 2);
    const auto inside = [&](const Decimal& number, int count, std::string_view side) {
        const double index = number.to_double();
        if (!(index >= 0 && index <= count - 1 && index == static_cast<int>(index))) {
            table.fail("pixel", fmt::format("{} is not a pixel: {} counts whole pixels from 0 to {}", number.text(),
                                            side, count - 1));
        }
        return static_cast<int>(index);
    };
    return {inside(numbers[0], window.width, "x"), inside(numbers[1], window.height, "y")};
}

Sphere<Decimal> read_sphere(const TomlTable& table) {
    table.allow_only({"center", "radius"});
    Sphere<Decimal> sphere{read_vector(table, "center"), table.decimal("radius")};
    if (sphere.radius.sign() <= 0) table.fail("radius", "must be above 0");
    return sphere;
}

Triangle<Decimal> read_triangle(const TomlTable& table) {
    table.allow_only({"vertices"});
    const std::vector<std::vector<Decimal>> rows = table.decimal_rows("vertices", 3, 3);
    const auto vertex = [&](std::size_t i) { return Vec3<Decimal>(rows[i][0], rows[i][1], rows[i][2]); };
    return {vertex(0), vertex(1), vertex(2)};
}

Scene<Decimal> read_scene(const TomlTable& root) {
    const TomlTable window = root.table("window");
    Scene<Decimal> scene{read_camera(root.table("camera")), read_window(window), {}, {}, {}};
    scene.pixel = read_pixel(window, scene.window);
    for (const TomlTable& sphere : root.tables("sphere")) scene.spheres.push_back(read_sphere(sphere));
    for (const TomlTable& triangle : root.tables("triangle")) scene.triangles.push_back(read_triangle(triangle));
    // The handout asks about one sphere and one triangle. More would need questions of their own.
    if (scene.spheres.size() > 1) root.fail("sphere", "is there twice; the questions are about one sphere");
    if (scene.triangles.size() > 1) root.fail("triangle", "is there twice; the questions are about one triangle");
    return scene;
}

int read_question_number(const TomlTable& table, const std::string& key) {
    const bool is_number =
        key.size() <= 2 && std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!is_number || key.empty() || std::stoi(key) < 1 || std::stoi(key) > 10) {
        table.fail(key, "is not a question; the handout's questions are 1 to 10");
    }
    return std::stoi(key);
}

/// A share or points: a finite number in [least, most].
double read_amount(const TomlTable& table, std::string_view key, double least, double most) {
    const double value = table.decimal(key).to_double();
    if (!(least <= value && value <= most)) {
        table.fail(key, most < 1e6 ? fmt::format("must be from {} to {}", least, most)
                                   : fmt::format("must be {} or more", least));
    }
    return value;
}

void read_points(const TomlTable& table, Rubric& rubric) {
    constexpr double most_points = 1e6;
    for (const std::string& key : table.keys()) {
        const int question = read_question_number(table, key);
        if (!table.is_table(key)) {
            rubric.points[question] = read_amount(table, key, 0, most_points);
            continue;
        }
        const TomlTable items = table.table(key);
        double sum = 0;
        for (const std::string& item : items.keys()) {
            sum += rubric.item_points[question][item] = read_amount(items, item, 0, most_points);
        }
        rubric.points[question] = sum;
    }
}

void read_tolerance(const TomlTable& table, Rubric& rubric) {
    constexpr double widest = 1e6;
    for (const std::string& key : table.keys()) {
        if (key == "default") {
            rubric.tolerance = read_amount(table, key, 0, widest);
        } else if (table.is_table(key)) {
            const TomlTable items = table.table(key);
            const int question = read_question_number(table, key);
            for (const std::string& item : items.keys()) {
                rubric.item_tolerance[fmt::format("{}.{}", question, item)] = read_amount(items, item, 0, widest);
            }
        } else {
            rubric.item_tolerance[std::to_string(read_question_number(table, key))] =
                read_amount(table, key, 0, widest);
        }
    }
}

Rubric read_rubric(const TomlTable& table) {
    table.allow_only({"pixel_conventions", "boundary", "follow_through", "min_decimals", "points", "tolerance"});
    Rubric rubric;
    if (table.has("pixel_conventions")) {
        rubric.pixel_conventions.clear();
        for (const std::string& name : table.strings("pixel_conventions")) {
            rubric.pixel_conventions.push_back(table.choice<PixelConvention>("pixel_conventions", name,
                                                                             {{"centre", PixelConvention::centre},
                                                                              {"grid", PixelConvention::grid},
                                                                              {"corner", PixelConvention::corner}}));
        }
        if (rubric.pixel_conventions.empty()) table.fail("pixel_conventions", "must name at least one convention");
    }
    if (table.has("boundary")) {
        rubric.boundary = table.choice<BoundaryPolicy>("boundary", table.string("boundary"),
                                                       {{"positive", BoundaryPolicy::positive},
                                                        {"nonnegative", BoundaryPolicy::nonnegative},
                                                        {"either", BoundaryPolicy::either}});
    }
    if (table.has("follow_through")) rubric.follow_through = read_amount(table, "follow_through", 0, 1);
    if (table.has("min_decimals")) rubric.min_decimals = table.integer("min_decimals", 0, 9);
    if (table.has("points")) read_points(table.table("points"), rubric);
    if (table.has("tolerance")) read_tolerance(table.table("tolerance"), rubric);
    return rubric;
}

std::string names_in(const std::filesystem::path& directory) {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(directory, error)) {
        if (entry.path().extension() == ".toml" && !entry.is_symlink()) names.push_back(entry.path().stem().string());
    }
    std::sort(names.begin(), names.end());
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

double Rubric::points_of(int question) const {
    const auto found = points.find(question);
    return found == points.end() ? points_per_question : found->second;
}

double unit_of(const std::vector<double>& key_value) {
    double unit = 1;
    for (const double x : key_value) unit = std::max(unit, std::abs(x));
    return unit;
}

std::optional<double> Rubric::tolerance_of(int question, const std::string& item) const {
    const std::string number = std::to_string(question);
    for (const std::string& key : {number + "." + item, number}) {
        if (const auto found = item_tolerance.find(key); found != item_tolerance.end()) return found->second;
    }
    return tolerance;
}

Assignment parse_assignment(std::string_view toml, const std::filesystem::path& path) {
    const TomlDocument document(toml, path);
    const TomlTable root = document.root();
    root.allow_only({"title", "camera", "window", "sphere", "triangle", "rubric"});
    Assignment assignment;
    assignment.name = path.stem().string();
    assignment.title = root.has("title") ? root.string("title") : assignment.name;
    assignment.scene = read_scene(root);
    if (root.has("rubric")) assignment.rubric = read_rubric(root.table("rubric"));
    return assignment;
}

Assignment load_assignment(const std::string& name_or_file, const std::filesystem::path& directory) {
    namespace fs = std::filesystem;
    fs::path path = name_or_file;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        path = directory / name_or_file;
        if (path.extension() != ".toml") path += ".toml";
    }
    if (!fs::is_regular_file(path, error)) {
        throw AssignmentError(fmt::format("no assignment \"{}\": it is neither a file nor one of {} (in {})",
                                          name_or_file, names_in(directory), directory.string()));
    }
    path = fs::canonical(path, error);
    constexpr std::uintmax_t largest_file = 1 << 20;
    if (fs::file_size(path, error) > largest_file) {
        throw AssignmentError(fmt::format("{}: larger than 1 MiB; that is no assignment", path.string()));
    }
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw AssignmentError(fmt::format("{}: can't be read; check its permissions", path.string()));
    return parse_assignment(text.str(), path);
}

}  // namespace reference
