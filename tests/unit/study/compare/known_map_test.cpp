#include "study/compare/known_map.hpp"

#include <gmock/gmock.h>

#include "scores/trajectory_score.hpp"
#include "sim/simulated_stream.hpp"
#include "sim/world_catalogue.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"
#include "tiny_world.hpp"

namespace ddtool::compare {
namespace {

/// The ATE of the estimator over a drive. `seen` may change the information of every scan before the estimator gets it.
template <typename Seen>
double ate_m(const Seen& seen) {
    const ddtool::test::TemporaryFolder folder;
    sim::SimulationSettings settings;
    settings.lidar.beams = 90;
    settings.odometry = sim::odometry_preset("poor");
    sim::SimulatedStream stream(sim::load_world(ddtool::test::write_tiny_world(folder / "tiny.json")), settings);
    const auto told = std::make_shared<ScanTruth>();
    stream.tell_truth(told);
    const auto passed_on = std::make_shared<ScanTruth>();
    KnownMapEstimator estimator(settings.odometry, 1, passed_on);
    Trajectory truth;
    while (const std::optional<SensorFrame> frame = stream.next()) {
        const std::int64_t stamp_ns = frame->scan.stamp_ns;
        passed_on->add(stamp_ns, seen(told->fisher_information(stamp_ns).value()));
        truth.push_back({frame->scan.stamp_ns, *frame->world_from_robot});
        estimator.process(*frame);
    }
    return score_against(estimator.trajectory(), truth).absolute->translation_m.rmse;
}

TEST(KnownMap, KnowsMoreTheMoreTheScansTell) {
    using Matrix = Eigen::Matrix3d;
    const double all = ate_m([](const Matrix& information) { return information; });
    const double a_hundredth = ate_m([](const Matrix& information) { return Matrix(0.01 * information); });
    const double nothing = ate_m([](const Matrix& /*information*/) { return Matrix(Matrix::Zero()); });
    EXPECT_LT(all, 0.002);
    EXPECT_LT(1.5 * all, a_hundredth);
    EXPECT_LT(1.5 * a_hundredth, nothing);
}

TEST(KnownMap, IsForSimulatedWorldsOnly) {
    KnownMapEstimator estimator({}, 1, std::make_shared<ScanTruth>());
    EXPECT_THAT(ddtool::test::thrown_text([&] { estimator.process({}); }), testing::HasSubstr("known-map"));
}

}  // namespace
}  // namespace ddtool::compare
