#include <nlohmann/json.hpp>

#include "harness/report/accuracy/report.h"
#include "harness/text/escape.h"

namespace harness::report {
namespace {

using nlohmann::ordered_json;
using namespace reference::accuracy;

ordered_json row_json(const Row& row) {
    const auto ulp = [&](double TError::*which) {
        return row.t_error ? ordered_json((*row.t_error).*which) : ordered_json(nullptr);
    };
    return {{"primitive", name_of(row.primitive)},
            {"kernel", escape_control(row.kernel)},
            {"scalar", escape_control(row.scalar)},
            {"source", escape_control(row.source)},
            {"distribution", escape_control(row.distribution)},
            {"hard", row.hard},
            {"rays", row.rays},
            {"ns_per_ray", row.ns_per_ray},
            {"ns_low", row.ns_low},
            {"ns_high", row.ns_high},
            {"wrong", row.wrong},
            {"wrong_per_million", row.wrong_per_million},
            {"wrong_low", row.wrong_low},
            {"wrong_high", row.wrong_high},
            {"max_ulp", ulp(&TError::max_ulp)},
            {"mean_ulp", ulp(&TError::mean_ulp)},
            {"pareto", row.pareto},
            {"certain", row.certain}};
}

ordered_json quartiles_json(const Quartiles& quartiles) {
    return {quartiles.low, quartiles.median, quartiles.high};
}

}  // namespace

std::string accuracy_json(const Measurement& measured) {
    ordered_json json = ordered_json::object();
    json["seed"] = measured.seed;
    json["rays"] = measured.rays;
    json["repetitions"] = measured.repetitions;
    json["compiler"] = escape_control(measured.compiler);
    json["flags"] = escape_control(measured.flags);
    json["processor"] = escape_control(measured.processor);
    json["rows"] = ordered_json::array();
    for (const Row& row : measured.rows) json["rows"].push_back(row_json(row));
    json["load"] = measured.load;
    const auto& [in_float, in_double, certified] = measured.key_ms;
    json["key_ms"] = {{"float", quartiles_json(in_float)},
                      {"double", quartiles_json(in_double)},
                      {"certified", quartiles_json(certified)}};
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace harness::report
