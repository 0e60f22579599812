#include "ddtool/methods/method.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "room_run.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

FilterSettings settings_of(const std::string& method) {
    FilterSettings settings;
    settings.rbpf = few_particles();
    settings.method.method = method;
    return settings;
}

Trajectory run(const FilterSettings& settings, std::size_t threads = 1) {
    ThreadPool pool(threads);
    const auto filter = make_filter(settings, DetectorTable(), pool);
    for (const SensorFrame& frame : room_drive()) {
        filter->update(frame);
    }
    return filter->trajectory();
}

double largest_error_m(const Trajectory& trajectory) {
    double largest = 0.0;
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        largest = std::max(largest, distance_m(trajectory[i].pose, *room_drive()[i].world_from_robot));
    }
    return largest;
}

TEST(Methods, AllKnowWhereTheRobotIsInARoom) {
    Trajectory odometry;
    for (const SensorFrame& frame : room_drive()) {
        odometry.push_back({frame.scan.stamp_ns, frame.odom_from_robot});
    }
    for (const std::string& name : method_names()) {
        const double error_m = largest_error_m(run(settings_of(name)));
        EXPECT_LT(error_m, name == "odometry" ? 1.001 * largest_error_m(odometry) : 0.12) << name;
    }
}

TEST(Methods, AreTheSameBytesOnAnyNumberOfThreads) {
    for (const std::string& name : method_names()) {
        EXPECT_EQ(poses_of(run(settings_of(name), 2)), poses_of(run(settings_of(name)))) << name;
    }
}

TEST(Methods, OdometryIsTheOdometry) {
    const Trajectory trajectory = run(settings_of("odometry"));
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        EXPECT_LT(distance_m(trajectory[i].pose, room_drive()[i].odom_from_robot), 1e-9) << i;
    }
}

TEST(Methods, AreTheirParts) {
    FilterSettings as_parts = settings_of("rbpf");
    as_parts.method.parts = parts_of(settings_of("paper-strategies-on-ours").method);
    EXPECT_EQ(poses_of(run(as_parts)), poses_of(run(settings_of("paper-strategies-on-ours"))));
    as_parts = settings_of("gmapping");
    as_parts.method.parts = parts_of(settings_of("paper").method);
    EXPECT_EQ(poses_of(run(as_parts)), poses_of(run(settings_of("paper"))));
}

TEST(Methods, WithoutTheirPartsAreThePlainFilter) {
    for (const char* name : {"paper", "paper-strategies-on-ours", "anti-degeneracy", "fisher-gate"}) {
        const char* const plain = runs_gmapping(name) ? "gmapping" : "rbpf";
        FilterSettings settings = settings_of(name);
        settings.method.parts = parts_of(settings_of(plain).method);
        EXPECT_EQ(poses_of(run(settings)), poses_of(run(settings_of(plain)))) << name;
    }
}

TEST(Methods, EachPartOfThePapersChangesTheOutcomeAlone) {
    const MethodParts paper = parts_of(settings_of("paper").method);
    for (const auto part : {&MethodParts::search, &MethodParts::trust, &MethodParts::resampling}) {
        FilterSettings settings = settings_of("rbpf");
        settings.rbpf.resample_share = 1.0;
        settings.rbpf.matcher.max_iterations = 0;  // leaves something for the search to improve
        const std::vector<Pose2> without = poses_of(run(settings));
        settings.method.parts.detector = "always";
        settings.method.parts.*part = paper.*part;
        EXPECT_NE(poses_of(run(settings)), without) << paper.*part;
    }
}

TEST(Methods, GmappingTakesADetectorAndThePartsOfThePaperAlone) {
    FilterSettings settings = settings_of("gmapping");
    settings.gmapping.update_distance_m = 0.3;
    settings.gmapping.resample_share = 1.0;
    const std::vector<Pose2> plain = poses_of(run(settings));
    settings.method.parts.detector = "always";
    EXPECT_EQ(poses_of(run(settings)), plain);
    const MethodParts paper = parts_of(settings_of("paper").method);
    for (const auto part : {&MethodParts::search, &MethodParts::trust, &MethodParts::resampling}) {
        FilterSettings with_part = settings;
        with_part.gmapping.matcher.halvings = 0;  // leaves something for the search to improve
        const std::vector<Pose2> without = poses_of(run(with_part));
        with_part.method.parts.*part = paper.*part;
        EXPECT_NE(poses_of(run(with_part)), without) << paper.*part;
    }
    settings.method.parts.trust = "information";
    EXPECT_THAT(
        test::thrown_text<UsageError>([&] { run(settings); }),
        testing::HasSubstr("filter.trust: expected none, lidar-score with the method gmapping, not 'information'"));
}

TEST(Methods, ThePapersIsGmappingWhereTheSwarmIsNotDegenerate) {
    FilterSettings settings = settings_of("paper");
    settings.method.parts.detector = "none";
    settings.method.parts.resampling = "systematic";
    EXPECT_EQ(poses_of(run(settings)), poses_of(run(settings_of("gmapping"))));
}

TEST(Methods, HaveTheirFiltersUpdateMotion) {
    FilterSettings settings = settings_of("gmapping");
    settings.gmapping.update_distance_m = 0.7;
    EXPECT_EQ(update_motion(settings).distance_m, 0.7);
    EXPECT_EQ(update_motion(settings).turn_rad, settings.gmapping.update_turn_rad);
    settings.method.method = "rbpf";
    EXPECT_EQ(update_motion(settings).distance_m, settings.rbpf.update_distance_m);
}

TEST(Methods, AskTheirDetectorInDoubtUnlessItIsThereToBeComparedWith) {
    const auto gate_of = [](const std::string& method, const std::string& detector, const std::string& gate = "") {
        MethodSettings settings;
        settings.method = method;
        settings.parts.detector = detector;
        settings.parts.gate = gate;
        return parts_of(settings).gate;
    };
    for (const char* method : {"anti-degeneracy", "paper-strategies-on-ours", "rbpf", "gmapping"}) {
        for (const char* detector : {"always", "oracle", "none"}) {
            EXPECT_EQ(gate_of(method, detector), "none") << method << " with " << detector;
            EXPECT_EQ(gate_of(method, detector, "in-doubt"), "in-doubt") << method << " with " << detector;
        }
        for (const char* detector : {"covariance", "step-spread", "some/model.pt"}) {
            EXPECT_EQ(gate_of(method, detector), "in-doubt") << method << " with " << detector;
            EXPECT_EQ(gate_of(method, detector, "none"), "none") << method << " with " << detector;
        }
    }
    EXPECT_EQ(gate_of("anti-degeneracy", ""), "in-doubt");
    EXPECT_EQ(gate_of("gmapping", ""), "none");
    EXPECT_EQ(gate_of("paper", "some/model.pt"), "none") << "the paper asks its network at every update";
}

TEST(Methods, UnknownNamesAreRefusedWithTheKnownOnes) {
    const auto refusal = [](auto set) {
        FilterSettings settings = settings_of("rbpf");
        set(settings.method);
        return test::thrown_text<UsageError>([&] { run(settings); });
    };
    EXPECT_THAT(refusal([](MethodSettings& m) { m.method = "gmaping"; }),
                testing::HasSubstr("filter.method: expected gmapping, rbpf, paper, paper-strategies-on-ours"));
    EXPECT_THAT(refusal([](MethodSettings& m) { m.parts.search = "wide"; }),
                testing::HasSubstr("filter.search: expected none, coarse-fine, correlative, not 'wide'"));
    EXPECT_THAT(refusal([](MethodSettings& m) { m.parts.trust = "x"; }), testing::HasSubstr("filter.trust: expected"));
    EXPECT_THAT(refusal([](MethodSettings& m) { m.parts.resampling = "x"; }),
                testing::HasSubstr("filter.resampling: expected systematic, enhanced"));
    EXPECT_THAT(refusal([](MethodSettings& m) { m.parts.odometry = "x"; }),
                testing::HasSubstr("filter.odometry: expected as-logged, learnt"));
    EXPECT_THAT(refusal([](MethodSettings& m) { m.parts.gate = "x"; }),
                testing::HasSubstr("filter.gate: expected in-doubt, none"));
    EXPECT_THAT(refusal([](MethodSettings& m) { m.parts.detector = "x"; }),
                testing::HasSubstr("filter.detector: expected"));
}

}  // namespace
}  // namespace ddtool
