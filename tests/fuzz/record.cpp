#include "harness/gradebook/record.h"

#include <nlohmann/json.hpp>

#include "harness/record/final_mark.h"
#include "tests/fuzz/properties.h"

namespace {

using harness::Graded;
using Bytes = std::vector<std::uint8_t>;

/// What the reports follow without a look.
std::string check_references(const Graded& graded) {
    for (const harness::QuestionScore& question : graded.score.questions) {
        for (const harness::ItemScore& item : question.items) {
            if (item.spec.question != question.number) return "an item of another question";
        }
    }
    if (!graded.findings.variants) return {};
    for (const auto* items : {&graded.findings.variants->broken, &graded.findings.variants->unmoved}) {
        for (const auto& item : *items) {
            if (item.run >= graded.findings.variants->runs.size()) return "a run that is not there";
        }
    }
    return {};
}

}  // namespace

std::string check_record(std::string_view given) {
    Bytes bytes(given.begin(), given.end());
    // A record that people can read is easier to change than one in CBOR.
    if (given.starts_with('{')) {
        const auto json = nlohmann::json::parse(given, nullptr, /*allow_exceptions=*/false);
        if (!json.is_discarded()) bytes = nlohmann::json::to_cbor(json);
    }
    const auto graded = harness::from_record(bytes);
    if (!graded) return {};
    if (std::string broken = check_references(*graded); !broken.empty()) return broken;
    const Bytes written = harness::to_record(*graded);
    const auto again = harness::from_record(written);
    if (!again) return "what was written is no record";
    if (harness::to_record(*again) != written) return "a record is read otherwise than it was written";
    const auto one = harness::points_that_count(*graded);
    const auto other = harness::points_that_count(*again);
    const bool is_nan = one && other && *one != *one && *other != *other;
    return one == other || is_nan ? "" : "the points are others after writing";
}
