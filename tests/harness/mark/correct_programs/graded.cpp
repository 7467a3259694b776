#include "tests/harness/mark/correct_programs/graded.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "reference/accuracy/rays/random_numbers.h"
#include "tests/given/temporary_folder.h"

namespace correct {
namespace {

using reference::Decimal;

void write(std::ostream& out, const reference::Vec3<Decimal>& p) {
    out << p.x.text() << ' ' << p.y.text() << ' ' << p.z.text() << '\n';
}

void write(std::ostream& out, const Task& task) {
    for (const int formula : task.program.formulas) out << formula << ' ';
    out << task.program.scalar << ' ' << task.program.printing << '\n';
    const auto& [camera, window, pixel, spheres, triangles, cylinders] = *task.scene;
    for (const auto& p : {camera.eye, camera.lookat, camera.vup}) write(out, p);
    for (const auto& x : {window.clip_left, window.clip_right, window.clip_bottom, window.clip_top, window.clip_near})
        out << x.text() << ' ';
    out << window.width << ' ' << window.height << ' ' << pixel.x << ' ' << pixel.y << '\n';
    write(out, spheres.front().center);
    out << spheres.front().radius.text() << '\n';
    for (const auto& p : {triangles.front().A, triangles.front().B, triangles.front().C}) write(out, p);
}

}  // namespace

std::string Program::describe() const {
    std::string text = fmt::format("{}, {}", scalars.at(static_cast<std::size_t>(scalar)),
                                   printings.at(static_cast<std::size_t>(printing)));
    for (std::size_t i = 0; i < stages.size(); ++i) {
        text += fmt::format("; {}: {}", stages[i].name, stages[i].formulas.at(static_cast<std::size_t>(formulas[i])));
    }
    return text;
}

Program random_program(std::uint64_t seed) {
    reference::accuracy::Random random(seed);
    Program program{};
    for (std::size_t i = 0; i < stages.size(); ++i) program.formulas[i] = random.whole(0, stages[i].count() - 1);
    program.scalar = std::max(0, random.whole(-2, static_cast<int>(scalars.size()) - 1));  // most are in float
    program.printing = random.whole(0, static_cast<int>(printings.size()) - 1);
    return program;
}

std::vector<std::string> printouts(std::string_view flags, const std::vector<Task>& tasks) {
    const TemporaryFolder folder;
    const auto input = folder.path() / "input", output = folder.path() / "output";
    std::ofstream file(input);
    for (const Task& task : tasks) write(file, task);
    file.close();
    const std::string command = fmt::format("{}{} < {} > {}", CORRECT_PROGRAMS, flags, input.string(), output.string());
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    std::ostringstream all;
    all << std::ifstream(output).rdbuf();
    std::vector<std::string> printouts;
    std::istringstream rest(std::move(all).str());
    for (std::string one; std::getline(rest, one, '\x01');) {
        rest.ignore(1);
        printouts.push_back(one);
    }
    if (printouts.size() != tasks.size()) throw std::runtime_error("some printouts are missing: " + command);
    return printouts;
}

std::vector<Loss> losses(const harness::Score& score) {
    std::vector<Loss> lost;
    bool is_finite = true;
    for (const auto& question : score.questions) {
        for (const auto& item : question.items) {
            is_finite = is_finite && !item.not_finite;
            if (item.verdict == harness::ItemVerdict::right) continue;
            const bool is_first_hit = item.spec.id == reference::item::first_object;
            lost.push_back({item.spec.id, item.not_finite || (is_first_hit && !is_finite),
                            fmt::format("question {}, {}: {} {} ({}), off by {}, allowed {}", question.number,
                                        item.spec.name, to_string(item.verdict), item.printed, item.diagnosis,
                                        item.error.value_or(NAN), item.allowance.value_or(INFINITY))});
        }
    }
    return lost;
}

}  // namespace correct
