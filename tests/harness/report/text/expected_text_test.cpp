#include "harness/report/text/expected_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/given/report/graded_samples.h"

namespace harness::report {
namespace {

using testing::StartsWith;

// The axes of the off-axis scene are the columns of its matrix; the first is (0.927345, -0.151241, -0.342282).

TEST(ExpectedText, ShowsAMatrixInTheOrderOfTheOneThatWasPrinted) {
    const ExpectedTexts texts = expected_texts(report_samples::marking().key);
    const ExpectedText& matrix = texts.at(reference::item::M_VCS_to_WCS);
    ItemScore printed;
    EXPECT_THAT(matrix.beside(printed), StartsWith("by rows\n[0.927345  0.0458"));
    printed.by_columns = true;
    EXPECT_THAT(matrix.beside(printed), StartsWith("by columns\n[0.927345  -0.151241  -0.342282  0]\n["));
    EXPECT_THAT(texts.at(reference::item::X_vcs).beside(printed), StartsWith("(0.927345, -0.151241, "));
}

}  // namespace
}  // namespace harness::report
