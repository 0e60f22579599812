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

}  // namespace
}  // namespace ddtool
