#include "reference/toml/scene_reader.h"

#include <fmt/format.h>

#include "reference/numbers/rational.h"

namespace reference {
namespace {

/// Twice this number, the denominator of a pixel's centre, still fits an int.
constexpr int most_pixels_per_side = 1 << 29;

/// The exact value. Fails if it is out of to_rational's range.
Rational exact(const TomlTable& table, std::string_view key, const Decimal& number) {
    const std::optional<Rational> x = to_rational(number);
    if (!x) {
        table.fail(key, fmt::format("has {}, which is out of range; write 0 or a number between 1e-300 and 1e150 in "
                                    "size, or scale the scene",
                                    number.text()));
    }
    return *x;
}

Vec3<Rational> exact(const TomlTable& table, std::string_view key, const Vec3<Decimal>& p) {
    return {exact(table, key, p.x), exact(table, key, p.y), exact(table, key, p.z)};
}

Vec3<Rational> difference(const Vec3<Rational>& p, const Vec3<Rational>& q) {
    return {Rational(p.x - q.x), Rational(p.y - q.y), Rational(p.z - q.z)};
}

Vec3<Rational> exact_cross(const Vec3<Rational>& p, const Vec3<Rational>& q) {
    return {Rational(p.y * q.z - p.z * q.y), Rational(p.z * q.x - p.x * q.z), Rational(p.x * q.y - p.y * q.x)};
}

bool is_zero(const Vec3<Rational>& p) {
    return p.x == 0 && p.y == 0 && p.z == 0;
}

Vec3<Decimal> read_vector(const TomlTable& table, std::string_view key) {
    const std::vector<Decimal> numbers = table.decimals(key, 3);
    return {numbers[0], numbers[1], numbers[2]};
}

Decimal read_positive(const TomlTable& table, std::string_view key, std::string_view reason) {
    const Decimal number = table.decimal(key);
    exact(table, key, number);
    if (number.sign() <= 0) table.fail(key, fmt::format("is {}, but must be above 0: {}", number.text(), reason));
    return number;
}

Camera<Decimal> read_camera(const TomlTable& table) {
    table.allow_only({"eye", "lookat", "vup"});
    const Camera<Decimal> camera{read_vector(table, "eye"), read_vector(table, "lookat"), read_vector(table, "vup")};
    const Vec3<Rational> view = difference(exact(table, "eye", camera.eye), exact(table, "lookat", camera.lookat));
    const Vec3<Rational> up = exact(table, "vup", camera.vup);
    if (is_zero(view)) table.fail("lookat", "equals eye; move it to the point that the camera looks at");
    if (is_zero(up)) table.fail("vup", "is zero; write the upward direction, such as [0, 1, 0]");
    if (is_zero(exact_cross(up, view))) {
        const bool along_y = view.x == 0 && view.z == 0;
        table.fail("vup", fmt::format("is parallel to the view from eye to lookat; write another, such as {}",
                                      along_y ? "[0, 0, 1]" : "[0, 1, 0]"));
    }
    return camera;
}

/// The window's extent along one axis must not be empty. If it runs backwards, the picture is mirrored, and a note says
/// so.
void check_extent(const TomlTable& table, std::string_view from, std::string_view to, std::string_view effect,
                  std::vector<std::string>& notes) {
    const Rational low = exact(table, from, table.decimal(from));
    const Rational high = exact(table, to, table.decimal(to));
    if (low == high) table.fail(to, fmt::format("equals {}, so the window is empty; change one of them", from));
    if (low > high) {
        notes.push_back(fmt::format("{} is greater than {}: the window is mirrored {}.", from, to, effect));
    }
}

Window<Decimal> read_window(const TomlTable& table, std::vector<std::string>& notes) {
    table.allow_only({"clip_left", "clip_right", "clip_bottom", "clip_top", "clip_near", "width", "height", "pixel"});
    check_extent(table, "clip_left", "clip_right", "left to right", notes);
    check_extent(table, "clip_bottom", "clip_top", "upside down", notes);
    return {table.decimal("clip_left"),
            table.decimal("clip_right"),
            table.decimal("clip_bottom"),
            table.decimal("clip_top"),
            read_positive(table, "clip_near", "the image plane is in front of the eye"),
            table.integer("width", 1, most_pixels_per_side),
            table.integer("height", 1, most_pixels_per_side)};
}

Pixel read_pixel(const TomlTable& table, const Window<Decimal>& window) {
    const std::vector<Decimal> numbers = table.decimals("pixel", 2);
    const auto inside = [&](const Decimal& number, int count, std::string_view side) {
        const Rational index = exact(table, "pixel", number);
        if (index < 0 || index >= count || index.get_den() != 1) {
            table.fail("pixel",
                       fmt::format("has {}, which is not a pixel of the window; {} is a whole number from 0 to {}",
                                   number.text(), side, count - 1));
        }
        return static_cast<int>(index.get_num().get_si());
    };
    return {inside(numbers[0], window.width, "x"), inside(numbers[1], window.height, "y")};
}

/// Reads the fields of an object from its table; `kind` names it in messages.
struct FieldReader {
    const TomlTable& table;
    std::string_view kind;

    void operator()(std::string_view key, Decimal& number) const {
        number = read_positive(table, key, fmt::format("a {} has a surface", kind));
    }
    void operator()(std::string_view key, Vec3<Decimal>& point) const {
        point = read_vector(table, key);
        exact(table, key, point);
    }
    void operator()(std::string_view key, const Vertices<Vec3<Decimal>>& vertices) const {
        const std::vector<std::vector<Decimal>> rows = table.decimal_rows(key, vertices.size(), 3);
        std::vector<Vec3<Rational>> exact_vertices;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            *vertices[i] = {rows[i][0], rows[i][1], rows[i][2]};
            exact_vertices.push_back(exact(table, key, *vertices[i]));
        }
        const auto edge = [&](std::size_t i) { return difference(exact_vertices[i], exact_vertices[0]); };
        if (!is_zero(exact_cross(edge(1), edge(2)))) return;
        table.fail(key, fmt::format("are on one line, so the {} has no area and no normal; move one of them", kind));
    }
};

template <class Object>
Object read_object(const TomlTable& table, std::string_view kind) {
    std::vector<std::string_view> keys = field_names<Object>();
    keys.emplace_back("material");
    table.allow_only(keys);
    Object object;
    for_each_field(FieldReader{table, kind}, object);
    return object;
}

template <class Object>
void read_objects(const TomlTable& root, Subject kind, std::vector<Object>& read) {
    for (const TomlTable& table : root.tables(to_string(kind)))
        read.push_back(read_object<Object>(table, to_string(kind)));
}

}  // namespace

Scene<Decimal> read_scene(const TomlTable& root, std::vector<std::string>& notes, PixelKey pixel) {
    const TomlTable window = root.table("window");
    Scene<Decimal> scene{read_camera(root.table("camera")), read_window(window, notes), {}};
    const bool reads_pixel = pixel == PixelKey::required || window.has("pixel");
    scene.pixel =
        reads_pixel ? read_pixel(window, scene.window) : Pixel{scene.window.width / 2, scene.window.height / 2};
    for_each_kind([&](Subject kind, auto& read) { read_objects(root, kind, read); }, scene);
    return scene;
}

}  // namespace reference
