#include "ddtool/robot/scan_truth.hpp"

#include <gtest/gtest.h>

namespace ddtool {
namespace {

TEST(ScanTruth, IsThatOfTheScanAskedFor) {
    ScanTruth truth;
    EXPECT_FALSE(truth.fisher_information(5));
    truth.add(5, Eigen::Matrix3d::Identity());
    truth.add(3, Eigen::Matrix3d::Constant(2.0));
    EXPECT_EQ(truth.fisher_information(5), Eigen::Matrix3d::Identity());
    EXPECT_EQ(truth.fisher_information(3), Eigen::Matrix3d::Constant(2.0)) << "stamps of logs jump back";
    EXPECT_FALSE(truth.fisher_information(4));
}

TEST(ScanTruth, RemembersTheLatestAlone) {
    ScanTruth truth;
    for (std::int64_t stamp_ns = 0; stamp_ns <= static_cast<std::int64_t>(ScanTruth::kept); ++stamp_ns) {
        truth.add(stamp_ns, Eigen::Matrix3d::Identity());
    }
    EXPECT_FALSE(truth.fisher_information(0));
    EXPECT_TRUE(truth.fisher_information(1));
}

}  // namespace
}  // namespace ddtool
