#include "tests/given/sample_measurement.h"

#include <algorithm>
#include <cmath>

#include "reference/accuracy/measure/statistics.h"

namespace samples {
namespace {

using namespace reference::accuracy;

struct Method {
    std::string kernel;
    std::string scalar;
    double ns;
    double wrong;  ///< per million hard rays
    double ulp;    ///< mean error on benign rays
};

struct Set {
    std::string name;
    bool hard;
    double slower;
    double share;  ///< the share of a method's wrong decisions
};

// Times and rates as they were measured on a real machine, to one or two digits.
const std::vector<Method> spheres{{"naive quadratic", "float", 8.8, 200055, 5.3},
                                  {"naive quadratic", "double", 9.3, 325, 6e-6},
                                  {"half-b", "float", 8.4, 200010, 5.1},
                                  {"half-b", "double", 9.0, 322, 5e-6},
                                  {"half-b branch-free", "double", 5.1, 322, 5e-6},
                                  {"stable", "float", 8.7, 198853, 5.3},
                                  {"stable", "double", 9.2, 320, 4e-6},
                                  {"Haines", "float", 11.8, 53658, 0.77},
                                  {"Haines", "double", 12.1, 120, 4e-8},
                                  {"certified", "double", 10.4, 0, 2e-7}};
const std::vector<Set> sphere_sets{
    {"benign", false, 1, 0}, {"grazing", true, 1.1, 2.5}, {"far and tiny", true, 1, 0.4}};
const std::vector<Method> triangles{{"3x3 inverse", "float", 18.3, 142888, 1.2},
                                    {"Cramer", "double", 18.1, 0, 2e-9},
                                    {"Möller-Trumbore", "float", 18.6, 140556, 1.1},
                                    {"Möller-Trumbore", "double", 19.9, 897, 2e-9},
                                    {"certified", "double", 6.4, 0, 3e-9}};
const std::vector<Set> triangle_sets{{"benign", false, 1, 0}, {"sliver", true, 1, 0.6}};
const std::vector<Method> cylinders{{"textbook", "float", 38.4, 175000, 4.7},
                                    {"slabs", "float", 7.8, 252000, 4.7},
                                    {"slabs", "double", 8.7, 51300, 5e-9},
                                    {"certified", "double", 19.9, 0, 5e-9}};
const std::vector<Set> cylinder_sets{{"benign", false, 1, 0}, {"rim-aimed", true, 1, 0.9}};
const std::vector<Method> casts{
    {"naive", "float", 210, 81000, 2.0}, {"naive", "double", 230, 410, 3e-9}, {"certified", "double", 340, 0, 2e-9}};
const std::vector<Set> cast_sets{{"benign", false, 1, 0}, {"ties", true, 1.1, 1}};

constexpr std::uint64_t rays = 131072;

Row row_of(Primitive primitive, const Method& method, const Set& set) {
    const double rate = std::min(1e6, method.wrong * set.share);
    Row row{primitive, method.kernel, method.scalar, "a book, p. 1", set.name, set.hard, rays};
    row.ns_per_ray = method.ns * set.slower;
    row.ns_low = row.ns_per_ray * 0.97;
    row.ns_high = row.ns_per_ray * 1.04;
    row.wrong = static_cast<std::uint64_t>(std::round(rate / 1e6 * static_cast<double>(rays)));
    row.wrong_per_million = 1e6 * static_cast<double>(row.wrong) / static_cast<double>(rays);
    const double spread = 1.96 * std::sqrt(row.wrong_per_million * 1e6 / static_cast<double>(rays));
    row.wrong_low = std::max(0.0, row.wrong_per_million - spread);
    row.wrong_high = row.wrong == 0 ? 29 : std::min(1e6, row.wrong_per_million + spread);
    row.certain = method.kernel.starts_with("certified");
    row.t_error = TError{400 * method.ulp, method.ulp * (set.hard ? 9 : 1)};
    return row;
}

void add(std::vector<Row>& rows, Primitive primitive, const std::vector<Method>& methods,
         const std::vector<Set>& sets) {
    for (const Set& set : sets) {
        std::vector<Row> added;
        for (const Method& method : methods) added.push_back(row_of(primitive, method, set));
        mark_pareto(added);
        rows.insert(rows.end(), added.begin(), added.end());
    }
}

}  // namespace

Measurement ladder() {
    Measurement measured{1,
                         rays,
                         9,
                         "g++ 12.2.0",
                         "-O3 -march=native -ffp-contract=off",
                         "A processor @ 2.60 GHz",
                         2.34,
                         {Quartiles{0.1, 0.2, 0.3}, {0.2, 0.3, 0.4}, {30, 31, 35}},
                         {}};
    add(measured.rows, Primitive::sphere, spheres, sphere_sets);
    add(measured.rows, Primitive::triangle, triangles, triangle_sets);
    add(measured.rows, Primitive::cylinder, cylinders, cylinder_sets);
    add(measured.rows, Primitive::cast, casts, cast_sets);
    return measured;
}

Measurement two_methods() {
    Row first{Primitive::sphere, "certified", "double", "a paper", "grazing", true, 1000, 10.5, 10.25, 11};
    first.wrong_high = 3827;
    first.t_error = TError{0.5, 0.125};
    first.pareto = true;
    first.certain = true;
    Row second{Primitive::sphere, "naive", "float", "a book", "grazing", true, 1000, 8, 7.5, 9.5};
    second.wrong = 12;
    second.wrong_per_million = 12000;
    second.wrong_low = 6878;
    second.wrong_high = 20856;
    second.pareto = true;
    return {7, 1000, 5, "g++ 12", "-O2", "", 0, {}, {first, second}};
}

Measurement hostile() {
    Measurement measured = two_methods();
    measured.compiler = "g++ <12> & \"co\"";
    measured.flags = "</style><script>alert(1)</script>";
    measured.processor = "a\x01z\xff]]>";
    Row& first = measured.rows[0];
    first.kernel = "<script>alert('k')</script> & \"kernel\"";
    first.source = "=HYPERLINK(\"http://x\"), with, commas\nand a line";
    first.distribution = measured.rows[1].distribution = "<b>grazing</b> & \x1b[31mred";
    measured.rows[1].kernel = "-b - sqrt(d), \"naive\"";
    return measured;
}

}  // namespace samples
