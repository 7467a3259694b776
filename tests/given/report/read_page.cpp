#include "tests/given/report/read_page.h"

#include "tests/given/report/told_by.h"

namespace report_samples {

nlohmann::json read_page(const std::string& page) {
    return nlohmann::json::parse(told_by("python3 '" RAYGRADE_PROJECT "/tests/given/report/read_page.py' \"$1\"", page),
                                 nullptr, false);
}

nlohmann::json read_markdown(const std::string& page) {
    return read_page(told_by("cmark --unsafe \"$1\"", page));
}

std::string xml_problems(const std::string& page) {
    return told_by("xmllint --noout --nonet \"$1\" || true", page);
}

}  // namespace report_samples
