#include <fmt/format.h>

#include "harness/report/accuracy/report.h"
#include "harness/report/data/csv_cell.h"

namespace harness::report {

using reference::accuracy::Row;

std::string accuracy_csv(const reference::accuracy::Measurement& measured) {
    std::string text =
        "primitive,kernel,scalar,source,distribution,hard,rays,ns_per_ray,ns_low,ns_high,wrong,wrong_per_million,"
        "wrong_low,wrong_high,max_ulp,p99_ulp,mean_ulp,pareto,pareto_error,gives_t,prepared,certain,latency_ns\r\n";
    for (const Row& row : measured.rows) {
        text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},", reference::accuracy::name_of(row.primitive),
                            csv_cell(row.kernel), csv_cell(row.scalar), csv_cell(row.source),
                            csv_cell(row.distribution), row.hard, row.rays, row.ns_per_ray, row.ns_low, row.ns_high,
                            row.wrong, row.wrong_per_million, row.wrong_low, row.wrong_high);
        text += row.t_error ? fmt::format("{},{},{}", row.t_error->max_ulp, row.t_error->p99_ulp, row.t_error->mean_ulp)
                            : ",,";
        text += fmt::format(",{},{},{},{},{},{}\r\n", row.pareto_wrong, row.pareto_error, row.gives_t, row.prepared,
                            row.certain, row.latency ? fmt::format("{}", row.latency->median) : "");
    }
    return text;
}

}  // namespace harness::report
