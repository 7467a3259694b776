#include "tests/given/report/read_page.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/given/temporary_folder.h"

namespace report_samples {
namespace {

/// The output of a command on stdout and stderr. The command finds the page in the file "$1".
std::string told_by(const std::string& command, const std::string& page, int& status) {
    const TemporaryFolder folder;
    const auto file = folder.write("page.html", page);
    const auto told = folder.path() / "told";
    // The folder's name needs no quoting: it has only letters and digits.
    status = std::system((command + " " + file.string() + " > " + told.string() + " 2>&1").c_str());
    std::ifstream in(told, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

nlohmann::json read_page(const std::string& page) {
    int status = 0;
    const std::string told = told_by("python3 '" RAYGRADE_PROJECT "/tests/given/report/read_page.py'", page, status);
    EXPECT_EQ(status, 0) << told;
    return nlohmann::json::parse(told, nullptr, false);
}

nlohmann::json read_markdown(const std::string& page) {
    int status = 0;
    const std::string html = told_by("cmark --unsafe", page, status);
    EXPECT_EQ(status, 0) << html;
    return read_page(html);
}

std::string xml_problems(const std::string& page) {
    int status = 0;
    const std::string told = told_by("xmllint --noout --nonet", page, status);
    return status == 0 ? "" : told;
}

}  // namespace report_samples
