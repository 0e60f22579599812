#include "ddtool/filter/scan_noise.hpp"

#include <gtest/gtest.h>

namespace ddtool {
namespace {

ScanNoise learnt(double sd_m, int scans) {
    ScanNoise noise;
    for (int scan = 0; scan < scans; ++scan) {
        noise.learn(sd_m * sd_m);
    }
    return noise;
}

TEST(ScanNoise, WeighsNoisierScansByTheInverseOfTheirVariance) {
    EXPECT_NEAR(learnt(0.04, 50).weight(0.02), 0.25, 1e-12);
    EXPECT_NEAR(learnt(0.06, 50).weight(0.02), 1.0 / 9.0, 1e-12);
}

TEST(ScanNoise, NeverWeighsAScanMoreThanTheSettingSays) {
    EXPECT_EQ(learnt(0.005, 50).weight(0.02), 1.0);
    EXPECT_EQ(ScanNoise().weight(0.02), 1.0);
}

TEST(ScanNoise, ZeroSwitchesItOff) {
    EXPECT_EQ(learnt(0.04, 50).weight(0.0), 1.0);
    EXPECT_EQ(learnt(0.0, 50).weight(0.0), 1.0);
}

TEST(ScanNoise, OneScanHardlyCountsAmongMany) {
    ScanNoise noise = learnt(0.04, 300);
    noise.learn(0.16 * 0.16);
    EXPECT_NEAR(noise.weight(0.02), 0.25, 0.02);
}

TEST(ScanNoise, FollowsALogThatBecomesNoisier) {
    ScanNoise noise = learnt(0.01, 1000);
    for (int scan = 0; scan < 2000; ++scan) {
        noise.learn(0.04 * 0.04);
    }
    EXPECT_NEAR(noise.weight(0.02), 0.25, 0.01);
}

TEST(ScanNoise, GivesBeamsTheInformationOfTheirOwnNoise) {
    EXPECT_NEAR(learnt(0.025, 50).information_factor(0.05), 2.0, 1e-12);
    EXPECT_NEAR(learnt(0.1, 50).information_factor(0.05), 0.125, 1e-12);
}

TEST(ScanNoise, BelievesNoBeamMoreThanTheMap) {
    const double most = learnt(ScanNoise::least_sd_m, 50).information_factor(0.05);
    EXPECT_EQ(learnt(0.001, 50).information_factor(0.05), most);
    EXPECT_NEAR(most, 10.33, 0.01);
}

/// The map is at first made of the scans that lie on it.
TEST(ScanNoise, BelievesTheAssumptionUntilItHasSeenEnough) {
    EXPECT_EQ(learnt(0.025, 19).information_factor(0.05), 1.0);
    EXPECT_NE(learnt(0.025, 20).information_factor(0.05), 1.0);
}

}  // namespace
}  // namespace ddtool
