// allowance_table [SCENES [v [KIND]]]: by kind of scene, how many correct programs lose marks and why, how large the
// allowance is beside what the programs are off by ("ratio"; "drawn": beside what programs with drawn roundings are off
// by), and how often it lets an error of a thousandth pass.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <set>

#include "reference/stages/scene_answers.h"
#include "tests/given/printed_values.h"
#include "tests/harness/mark/correct_programs/graded.h"
#include "tests/harness/mark/correct_programs/scenes.h"

namespace {

using namespace correct;

struct Row {
    int programs = 0, losing = 0, not_finite = 0;
    int items = 0, thousandth = 0;
    int well_posed = 0, thousandth_of_those = 0;  ///< items of scenes whose condition is below 10^4
    int above_percent = 0, without_bound = 0;
    int drawn = 0, drawn_losing = 0;
    std::vector<double> ratios = {}, drawn_ratios = {};
    std::map<std::string, int> reasons = {};
    std::map<reference::ItemId, std::vector<double>> by_item = {};
};

/// By what factor the scene may amplify an error of its numbers: the largest of the view's, the pixel's, the sphere's
/// and the triangle's.
double condition_of(const student::Marking& marking) {
    const auto scene = reference::convert_scene<double>(marking.assignment.scene,
                                                        [](const reference::Decimal& x) { return x.to_double(); });
    const auto answers =
        reference::answer_scene(scene, reference::PixelConvention::centre, reference::Boundary::positive);
    using reference::length;
    const auto view = scene.camera.eye - scene.camera.lookat;
    const double upright = length(view) * length(scene.camera.vup) / length(reference::cross(view, scene.camera.vup));
    const auto& M = answers.triangle->system.matrix;
    const double det = std::abs(reference::dot(M[0], reference::cross(M[1], M[2])));
    double triangle = 0;
    for (int i = 0; i < 3; ++i)
        triangle = std::max(triangle, length(M[i]) * length(reference::cross(M[(i + 1) % 3], M[(i + 2) % 3])) / det);
    const auto& quadratic = answers.sphere->quadratic;
    const double sphere = std::abs(quadratic.b * quadratic.b / quadratic.d);
    const double pixel =
        length(scene.camera.eye) / length(reference::Vec3<double>(answers.camera.P_WCS - scene.camera.eye));
    return std::max({upright, triangle, sphere, pixel});
}

double median(std::vector<double> x) {
    if (x.empty()) return NAN;
    std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2), x.end());
    return x[x.size() / 2];
}

using Errors = std::map<reference::ItemId, double>;

/// Item by item, the largest error of the programs.
void widen(Errors& widest, const harness::Score& score) {
    for (const auto& question : score.questions) {
        for (const auto& item : question.items) {
            double& most = widest[item.spec.id];
            most = std::max(most, item.error.value_or(0));
        }
    }
}

/// What so many programs with drawn roundings are off by.
Errors errors_of_drawn(const student::Marking& marking, int programs, std::uint64_t& seed, Row& row) {
    std::vector<Task> tasks;
    for (int i = 0; i < programs; ++i) {
        tasks.push_back({&marking.assignment.scene, random_program(seed++)});
        tasks.back().program.printing = 2;
    }
    Errors widest;
    for (const std::string& printed : printouts(drawn_roundings, tasks)) {
        const harness::Score score = mark(printed, marking);
        const std::vector<Loss> lost = losses(score);
        ++row.drawn;
        row.drawn_losing += std::any_of(lost.begin(), lost.end(), [](const Loss& l) { return !l.not_finite; }) ? 1 : 0;
        widen(widest, score);
    }
    return widest;
}

Row row_of(std::string_view kind, std::uint64_t scenes, bool verbose) {
    Row row;
    constexpr int drawn_programs = 200;
    std::uint64_t program = 0, drawn_program = 0;
    for (std::uint64_t seed = 0; seed < scenes; ++seed) {
        const reference::Assignment assignment = scene_of(kind, seed);
        const student::Marking marking{assignment, make_key(assignment, reference::Precision::certified)};
        const double condition = condition_of(marking);
        Errors widest;
        for (const std::string_view flags : flag_sets) {
            std::vector<Task> tasks;
            for (int i = 0; i < 5; ++i) {
                tasks.push_back({&marking.assignment.scene, random_program(program++)});
                if (i < 4) tasks.back().program.printing = 2, tasks.back().program.scalar = 0;
            }
            const std::vector<std::string> printed = printouts(flags, tasks);
            for (std::size_t i = 0; i < tasks.size(); ++i) {
                const harness::Score score = mark(printed[i], marking);
                ++row.programs;
                const std::vector<Loss> lost = losses(score);
                const bool finite = std::any_of(lost.begin(), lost.end(), [](const Loss& l) { return !l.not_finite; });
                row.losing += finite ? 1 : 0;
                row.not_finite += !lost.empty() && !finite ? 1 : 0;
                for (const Loss& loss : lost) {
                    if (loss.not_finite) continue;
                    ++row.reasons[fmt::format("{} {}", to_string(loss.item.subject), loss.item.name)];
                    if (verbose)
                        std::cout << assignment.name << ", " << flags << ": " << loss.text << "\n    "
                                  << tasks[i].program.describe() << "\n";
                }
                if (tasks[i].program.scalar != 0 || tasks[i].program.printing != 2) continue;
                widen(widest, score);
            }
        }
        Errors drawn = errors_of_drawn(marking, drawn_programs, drawn_program, row);
        for (const auto& question : marking.key.questions) {
            for (const auto& item : question.items) {
                const reference::Answer& answer = item.answers.front();
                const auto* numbers = std::get_if<reference::Numbers>(&answer.value);
                if (numbers == nullptr) continue;
                std::size_t k = 0;
                for (std::size_t i = 0; i < numbers->size(); ++i)
                    if (std::abs((*numbers)[i]) > std::abs((*numbers)[k])) k = i;
                const double allowance = answer.allowance[k], size = std::abs((*numbers)[k]);
                const bool passes = allowance >= 1e-3 * (size > 0 ? size : 1);
                ++row.items;
                row.thousandth += passes ? 1 : 0;
                row.well_posed += condition < 1e4 ? 1 : 0;
                row.thousandth_of_those += condition < 1e4 && passes ? 1 : 0;
                row.without_bound += std::isfinite(allowance) ? 0 : 1;
                row.above_percent += allowance >= 1e-2 * size && size > 0 ? 1 : 0;
                const double all = *std::max_element(answer.allowance.begin(), answer.allowance.end());
                const double most = widest[item.spec.id];
                if (most > 0 && std::isfinite(all))
                    row.ratios.push_back(all / most), row.by_item[item.spec.id].push_back(all / most);
                if (drawn[item.spec.id] > 0 && std::isfinite(all))
                    row.drawn_ratios.push_back(all / drawn[item.spec.id]);
            }
        }
    }
    return row;
}

void add(Row& all, const Row& row) {
    all.programs += row.programs, all.losing += row.losing, all.not_finite += row.not_finite;
    all.items += row.items, all.thousandth += row.thousandth;
    all.well_posed += row.well_posed, all.thousandth_of_those += row.thousandth_of_those;
    all.above_percent += row.above_percent, all.without_bound += row.without_bound;
    all.drawn += row.drawn, all.drawn_losing += row.drawn_losing;
    all.ratios.insert(all.ratios.end(), row.ratios.begin(), row.ratios.end());
    all.drawn_ratios.insert(all.drawn_ratios.end(), row.drawn_ratios.begin(), row.drawn_ratios.end());
}

void print(std::string_view kind, const Row& row) {
    std::cout << fmt::format("{:15}{:9}{:8}{:6}{:8}{:8}{:9}{:8}{:8}{:10}{:8.1f}{:8}{:8}{:8.1f}\n", kind, row.programs,
                             row.losing, row.not_finite, row.items, row.thousandth, row.well_posed,
                             row.thousandth_of_those, row.above_percent, row.without_bound, median(row.ratios),
                             row.drawn, row.drawn_losing, median(row.drawn_ratios))
              << std::flush;
    for (const auto& [reason, n] : row.reasons) std::cout << "    " << reason << ": " << n << "\n";
}

void print_items(const Row& row) {
    for (const auto& [id, ratios] : row.by_item)
        std::cout << fmt::format("    {} {}: ratio {:.1f}\n", to_string(id.subject), id.name, median(ratios));
}

}  // namespace

int main(int argc, char** argv) {
    const std::uint64_t scenes = argc > 1 ? std::stoull(argv[1]) : 10;
    const bool verbose = argc > 2;
    std::cout << fmt::format("{:15}{:>9}{:>8}{:>6}{:>8}{:>8}{:>9}{:>8}{:>8}{:>10}{:>8}{:>8}{:>8}{:>8}\n", "scenes",
                             "programs", "losing", "nan", "items", "1e-3", "posed", "1e-3", "> 1 %", "unbounded",
                             "ratio", "drawn", "losing", "ratio");
    const auto print_kind = [&](std::string_view kind) {
        if (argc > 3 && kind != argv[3]) return Row();
        const Row row = row_of(kind, scenes, verbose);
        print(kind, row);
        if (verbose) print_items(row);
        return row;
    };
    Row all;
    for (const std::string_view kind : kinds) add(all, print_kind(kind));
    print("all", all);
    for (const std::string_view kind : kinds_beyond_float) print_kind(kind);
}
