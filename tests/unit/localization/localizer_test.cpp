#include "localization/localizer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "ddtool/methods/method.hpp"
#include "known_places.hpp"
#include "thrown_text.hpp"

namespace ddtool::localization {
namespace {

using test::drive;
using test::true_map;

class Localization {
public:
    Localization(std::shared_ptr<const OccupancyGrid> map, std::optional<StartPose> start, std::size_t particles = 30)
        : localizer_(RbpfSettings{}, {.least_particles = particles}, threads_, make_strategies({}, {}), std::move(map),
                     start) {}

    struct Seen {
        double error_m = 0.0;
        double along_sd_m = 0.0;  ///< in the direction of x
        Standing standing;
        double way_m = 0.0;
        std::size_t matches = 0;  ///< different ones
    };
    /// What is known after each update; `moved` is put before the odometry.
    std::vector<Seen> over(std::span<const SensorFrame> frames, const Pose2& moved = {}) {
        std::vector<Seen> all;
        for (SensorFrame frame : frames) {
            frame.odom_from_robot = moved * frame.odom_from_robot;
            if (const std::optional<Update> update = localizer_.update(frame)) {
                way_m_ += std::hypot(update->matched.odometry_motion.x_m, update->matched.odometry_motion.y_m);
                std::set<std::pair<double, double>> matches;
                for (const SnapshotParticle& particle : update->matched.particles) {
                    matches.insert({particle.pose.x_m, particle.pose.y_m});
                }
                all.push_back({distance_m(update->pose, *frame.world_from_robot), std::sqrt(update->covariance(0, 0)),
                               localizer_.standing(), way_m_, matches.size()});
            }
        }
        return all;
    }
    Localizer& localizer() { return localizer_; }

private:
    ThreadPool threads_{1};
    Localizer localizer_;
    double way_m_ = 0.0;
};

RbpfSettings few() {
    RbpfSettings settings;
    settings.particles = 10;
    return settings;
}

const std::vector<SensorFrame>& rooms_drive() {
    static const std::vector<SensorFrame> frames = drive(test::two_rooms(), 2);
    return frames;
}

std::shared_ptr<const OccupancyGrid> rooms_map() {
    static const auto map = true_map(drive(test::two_rooms(), 1));
    return map;
}

TEST(Localizer, FollowsAGivenStart) {
    Localization one(rooms_map(), StartPose{.pose = {0.3, -0.2, 0.1}});
    const auto seen = one.over(rooms_drive());
    ASSERT_GT(seen.size(), 50U);
    for (std::size_t i = 10; i < seen.size(); ++i) {
        EXPECT_LT(seen[i].error_m, 0.05) << i;
        EXPECT_GT(seen[i].standing.probability, 0.9) << i;
    }
    EXPECT_EQ(one.localizer().trajectory().size(), rooms_drive().size());
    EXPECT_EQ(seen.back().standing.particles, 30U);
}

TEST(Localizer, ManyParticlesShareTheMatchesOfSome) {
    const auto seen = Localization(rooms_map(), StartPose{.pose = {0.3, -0.2, 0.1}}, 300).over(rooms_drive());
    for (std::size_t i = 10; i < seen.size(); ++i) {
        EXPECT_LT(seen[i].error_m, 0.05) << i;
        EXPECT_NEAR(static_cast<double>(seen[i].standing.particles), 300.0, 5.0) << i;
        EXPECT_LE(seen[i].matches, 16U) << i;
        EXPECT_GE(seen[i].matches, 4U) << i;
    }
}

TEST(Localizer, FindsItselfWithoutAStart) {
    const auto later = std::span(rooms_drive()).subspan(rooms_drive().size() / 2);
    const auto seen = Localization(rooms_map(), std::nullopt).over(later);
    EXPECT_LT(seen.back().error_m, 0.05);
    EXPECT_GT(seen.back().standing.probability, 0.9);
    for (const auto& moment : seen) {
        EXPECT_FALSE(moment.error_m > 0.5 && moment.standing.probability > 0.9) << moment.way_m;
    }
}

TEST(Localizer, SameSeedSameBytes) {
    const auto frames = std::span(rooms_drive()).first(rooms_drive().size() / 3);
    const auto one = Localization(rooms_map(), std::nullopt).over(frames);
    const auto other = Localization(rooms_map(), std::nullopt).over(frames);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].error_m, other[i].error_m);
        EXPECT_EQ(one[i].standing.probability, other[i].standing.probability);
    }
}

/// The robot is lifted from one room into the other, and its wheels notice nothing.
TEST(Localizer, NoticesBeingCarriedAway) {
    const auto frames = std::span(rooms_drive());
    const auto x_above = [&](double x_m) {
        return static_cast<std::size_t>(
            std::ranges::find_if(frames, [&](const SensorFrame& frame) { return frame.world_from_robot->x_m > x_m; }) -
            frames.begin());
    };
    const std::size_t from = x_above(1.9);
    const std::size_t to = x_above(11.0);
    Localization one(rooms_map(), StartPose{.pose = {}});
    const auto before = one.over(frames.first(from));
    EXPECT_GT(before.back().standing.probability, 0.9);
    const Pose2 moved = frames[from].odom_from_robot * inverse(frames[to].odom_from_robot);
    const auto after = one.over(frames.subspan(to), moved);
    std::optional<double> noticed;
    for (const auto& moment : after) {
        if (!noticed && moment.standing.probability < 0.5) {
            noticed = moment.way_m - before.back().way_m;
        }
    }
    ASSERT_TRUE(noticed.has_value());
    EXPECT_LT(*noticed, 2.0);
    EXPECT_LT(after.back().error_m, 0.05);
    EXPECT_GT(after.back().standing.probability, 0.9);
}

/// The robot is lifted into the other room, and somebody tells it so while it stands there.
TEST(Localizer, BeginsAnewWhereItIsTold) {
    const auto frames = std::span(rooms_drive());
    const auto carried_to = static_cast<std::size_t>(
        std::ranges::find_if(frames, [](const SensorFrame& frame) { return frame.world_from_robot->x_m > 11.0; }) -
        frames.begin());
    Localization one(rooms_map(), StartPose{.pose = {}});
    one.over(frames.first(20));
    const Pose2 moved = frames[19].odom_from_robot * inverse(frames[carried_to].odom_from_robot);
    const Pose2 truth = *frames[carried_to].world_from_robot;
    one.localizer().expect_at({.pose = {truth.x_m + 0.3, truth.y_m - 0.2, truth.theta_rad + 0.1}});
    const auto after = one.over(frames.subspan(carried_to), moved);
    ASSERT_FALSE(after.empty());
    for (std::size_t i = 0; i < after.size(); ++i) {
        EXPECT_LT(after[i].error_m, i == 0 ? 0.3 : 0.1) << i;
        EXPECT_EQ(after[i].standing.place, PlaceState::found) << i;
        EXPECT_FALSE(after[i].standing.searched) << i;
    }
    EXPECT_EQ(one.localizer().trajectory().size(), 20U + frames.size() - carried_to);
}

TEST(Localizer, TheCovarianceGrowsAlongACorridor) {
    const auto map = true_map(drive(test::long_corridor(), 1));
    const std::vector<SensorFrame> frames = drive(test::long_corridor(), 3);
    const auto seen = Localization(map, StartPose{.pose = {-1.0, 0.0, 0.0}}).over(frames);
    const auto sd_at = [&](double way_m) {
        return std::ranges::find_if(seen, [&](const auto& moment) { return moment.way_m > way_m; })->along_sd_m;
    };
    EXPECT_LT(sd_at(1.0), 0.03);
    EXPECT_GT(sd_at(12.0), 3.0 * sd_at(1.0));
    EXPECT_GT(sd_at(12.0), 0.05);
    EXPECT_GT(sd_at(30.0), 0.05);
    EXPECT_LT(seen.back().along_sd_m, 0.03);
    EXPECT_LT(seen.back().error_m, 0.05);
    for (const auto& moment : seen) {
        EXPECT_LT(moment.error_m, std::max(0.1, 4.0 * moment.along_sd_m)) << moment.way_m;
    }
}

/// The map has one room; the drive goes on into the other.
TEST(Localizer, MapsOnWhereItHasFoundItself) {
    const std::vector<SensorFrame> today = drive(test::two_rooms(), 1);
    const auto left =
        std::ranges::find_if(today, [](const SensorFrame& frame) { return frame.world_from_robot->x_m > 3.0; });
    const auto map = true_map({today.begin(), left});
    ThreadPool threads(1);
    Localizer localizer(few(), {}, threads, make_strategies({}, {}), map, std::nullopt, MapUse::going_on);
    double worst_m = 0.0;
    for (const SensorFrame& frame : rooms_drive()) {
        if (const std::optional<Update> update = localizer.update(frame); update && localizer.is_mapping()) {
            worst_m = std::max(worst_m, distance_m(update->pose, *frame.world_from_robot));
        }
    }
    EXPECT_TRUE(localizer.is_mapping());
    EXPECT_LT(worst_m, 0.15);
    const auto walls_right_of = [](const OccupancyGrid& grid, int x_cells) {
        const CellBox box = grid.observed_box();
        std::size_t count = 0;
        for (int y = box.y_min; y < box.y_max; ++y) {
            for (int x = x_cells; x < box.x_max; ++x) {
                count += grid.occupied({x, y}) ? 1 : 0;
            }
        }
        return count;
    };
    EXPECT_GT(walls_right_of(localizer.map(), 220), walls_right_of(*map, 220) + 50);
    EXPECT_EQ(localizer.trajectory().size(), rooms_drive().size());
}

TEST(Localizer, AnEmptyMapIsRefused) {
    EXPECT_NE(ddtool::test::thrown_text(
                  [] { Localization(std::make_shared<OccupancyGrid>(OccupancySettings{}), std::nullopt); }),
              "");
}

}  // namespace
}  // namespace ddtool::localization
