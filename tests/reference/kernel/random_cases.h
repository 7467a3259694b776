// Draws random cases and checks each.
#pragma once

#include <gtest/gtest.h>
// gtest must come first: RapidCheck's printers depend on it.
#include <rapidcheck/detail/Configuration.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

namespace random_cases {

/// Checks as many seeds, unless RC_PARAMS says how many. RapidCheck reads that variable once for the whole program, so
/// no test may set it.
template <class Check>
void for_seeds(std::string_view name, int rays, Check check) {
    rc::detail::TestParams params = rc::detail::configuration().testParams;
    if (std::getenv("RC_PARAMS") == nullptr) params.maxSuccess = rays;
    const auto seeds = rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    rc::detail::TestMetadata metadata;
    metadata.description = std::string(name);
    const auto result = rc::detail::checkTestable([&] { check(*seeds); }, metadata, params);
    std::ostringstream told;
    rc::detail::printResultMessage(result, told);
    EXPECT_TRUE(result.template is<rc::detail::SuccessResult>()) << name << told.str();
    if (std::getenv("RC_PARAMS") == nullptr) {
        EXPECT_EQ(result.template get<rc::detail::SuccessResult>().numSuccess, rays) << name;
    }
}

}  // namespace random_cases
