#include "harness/autograder/autograder.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/autograder/program_files.h"
#include "harness/autograder/scripts.h"
#include "harness/machine/bounded_file.h"
#include "harness/machine/errors.h"
#include "harness/machine/zip_writer.h"
#include "harness/text/printable.h"

namespace harness::autograder {
namespace {

/// One word per line, as the scripts read them.
std::string options_text(const Settings& settings) {
    std::string text;
    for (const std::string& word : settings.options) text += word + '\n';
    return text;
}

std::string bytes_of(const std::filesystem::path& file) {
    constexpr std::uintmax_t most = std::uintmax_t{256} << 20U;
    BoundedFile read = read_bounded(file, most, Links::follow);
    if (!read.is_whole()) throw HarnessError(in_quotes(file) + " cannot be packed: " + why_not_whole(read, most) + ".");
    return std::move(read.bytes);
}

}  // namespace

void write_gradescope_zip(std::ostream& out, const Settings& settings) {
    using Mode = ZipWriter::Mode;
    ZipWriter zip(out);
    zip.add("setup.sh", scripts::setup, Mode::executable);
    zip.add("run_autograder", scripts::run_autograder, Mode::executable);
    zip.add("options", options_text(settings));
    zip.add("assignment/" + settings.file_name, settings.toml);
    zip.add("self_test.cpp", scripts::self_test_cpp);
    zip.add("raygrade/raygrade", scripts::raygrade, Mode::executable);
    for (const ProgramFile& file : program_files())
        zip.add("raygrade/" + file.path, bytes_of(file.from), file.is_executable ? Mode::executable : Mode::plain);
    zip.close();
}

std::vector<TextFile> classroom50_files(const Settings& settings, std::string_view image) {
    // Checking out fails for any account but root.
    const nlohmann::ordered_json runtime{{"container", {{"image", image}, {"user", "root"}}}};
    return {{"autograder.py", std::string(scripts::autograder_py)},
            {"options", options_text(settings)},
            {"assignment/" + settings.file_name, settings.toml},
            {"runtime.json", runtime.dump(2) + "\n"}};
}

}  // namespace harness::autograder
