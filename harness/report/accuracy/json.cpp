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

ordered_json item_json(const ItemAccuracy& item) {
    ordered_json errors = ordered_json::array();
    for (const ItemError& error : item.errors) {
        ordered_json json{{"scalar", error.scalar}, {"decided_otherwise", error.otherwise}};
        json["error"] = error.otherwise ? ordered_json(nullptr) : ordered_json(error.absolute);
        json["error_ulp"] = error.otherwise ? ordered_json(nullptr) : ordered_json(error.ulp);
        json["of_allowance"] = error.otherwise ? ordered_json(nullptr) : ordered_json(error.of_allowance);
        errors.push_back(json);
    }
    const bool is_number = item.ulp > 0;
    return {{"question", item.spec.question},
            {"name", item.spec.name},
            {"ulp", is_number ? ordered_json(item.ulp) : ordered_json(nullptr)},
            {"allowance", is_number ? ordered_json(item.allowance) : ordered_json(nullptr)},
            {"errors", errors}};
}

ordered_json assignment_json(const AssignmentAccuracy& assignment) {
    ordered_json items = ordered_json::array();
    for (const ItemAccuracy& item : assignment.items) items.push_back(item_json(item));
    ordered_json decisions = ordered_json::array();
    for (const Decision& decision : assignment.decisions) {
        decisions.push_back({{"what", decision.what},
                             {"asks", decision.asks},
                             {"sign", decision.sign},
                             {"value", decision.value},
                             {"hangs_on_rounding", decision.hangs_on_rounding()},
                             {"float_is_sure", decision.float_is_sure},
                             {"double_is_sure", decision.double_is_sure},
                             {"wrong", decision.wrong}});
    }
    return {{"name", escape_control(assignment.assignment)},
            {"title", escape_control(assignment.title)},
            {"items", items},
            {"decisions", decisions}};
}

}  // namespace

std::string accuracy_json(const AccuracyFindings& findings) {
    ordered_json json = ordered_json::object();
    if (const auto& measured = findings.measured) {
        json["seed"] = measured->seed;
        json["rays"] = measured->rays;
        json["repetitions"] = measured->repetitions;
        json["compiler"] = escape_control(measured->compiler);
        json["flags"] = escape_control(measured->flags);
        json["processor"] = escape_control(measured->processor);
        json["rows"] = ordered_json::array();
        for (const Row& row : measured->rows) json["rows"].push_back(row_json(row));
        json["load"] = measured->load;
        const auto& [in_float, in_double, certified] = measured->key_ms;
        json["key_ms"] = {{"float", quartiles_json(in_float)},
                          {"double", quartiles_json(in_double)},
                          {"certified", quartiles_json(certified)}};
    }
    if (findings.assignment) json["assignment"] = assignment_json(*findings.assignment);
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace harness::report
