#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "ddtool/base/random.hpp"
#include "methods/settings_json.hpp"
#include "small_run.hpp"
#include "system/setting_rows.hpp"

namespace ddtool {
namespace {

/// A few scans, far enough from each other that each of them causes an update.
const std::vector<SensorFrame>& few_scans() {
    static const std::vector<SensorFrame> scans = [] {
        constexpr std::size_t every = 8;
        std::vector<SensorFrame> kept;
        test::SmallRun run;
        std::size_t seen = 0;
        (void)run.run([&](const SensorFrame& frame, const auto& /*update*/) {
            if (seen++ % every == 0) {
                kept.push_back(frame);
            }
            return kept.size() < 6;
        });
        return kept;
    }();
    return scans;
}

class Scans : public SensorStream {
public:
    std::optional<SensorFrame> next() override {
        return given_ < few_scans().size() ? std::optional(few_scans()[given_++]) : std::nullopt;
    }
    [[nodiscard]] double fraction_read() const override { return 0.0; }

private:
    std::size_t given_ = 0;
};

/// Large swarms take long and test nothing that small ones do not.
constexpr double most_particles = 8.0;

double least_of(const Setting& setting) { return setting.allowed.least; }
double most_of(const Setting& setting) { return setting.key == "particles" ? most_particles : setting.allowed.most; }

/// A random value of the setting's range. If the range lies above 0, every order of magnitude is equally likely.
double drawn(const Setting& setting, RandomStream& random) {
    const double least = least_of(setting);
    const double most = most_of(setting);
    return least > 0.0 ? least * std::pow(most / least, random.uniform()) : least + (most - least) * random.uniform();
}

Json value_of(const Setting& setting, double number) {
    if (setting.allowed.kind == Allowed::Kind::whole) {
        return number < 1e18 ? Json(std::llround(number)) : Json(~std::uint64_t{0});
    }
    return number;
}

bool is_number(const Setting& setting) {
    return setting.allowed.kind == Allowed::Kind::whole || setting.allowed.kind == Allowed::Kind::number;
}

Json few_particles_of(const std::string& method) {
    Json json = filter_settings_json({});
    json["method"] = method;
    json["particles"] = 3;
    return json;
}

void expect_finite(const Json& json, const std::string& what) {
    const FilterSettings settings = filter_settings_from_json(json);
    ThreadPool threads(1);
    const auto filter = make_filter(settings, DetectorTable(), threads);
    Scans scans;
    const FilterRun run = run_filter(scans, *filter, [](const auto&...) { return true; });
    ASSERT_EQ(run.trajectory.size(), few_scans().size()) << what << ": " << run.ended_early;
    for (const StampedPose& stamped : run.trajectory) {
        const Pose2& pose = stamped.pose;
        ASSERT_TRUE(std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.theta_rad)) << what;
    }
    EXPECT_TRUE(filter->pose_covariance().allFinite()) << what;
}

/// A method in which the setting has an effect.
std::string method_of(const std::string& path) {
    const std::string group = path.substr(0, path.find('.'));
    if (group == "coarse_fine" || group == "enhanced_resampling") {
        return "paper-strategies-on-ours";
    }
    if (group == "failed_match") {
        return "paper";
    }
    if (group == "correlative") {
        return "dn-csm";
    }
    if (group == "gmapping") {
        return "gmapping";
    }
    return group == "eigenvalue_gate" ? "fisher-gate" : "anti-degeneracy";
}

/// Tries the ends of each range and a value in between, one setting at a time.
TEST(SettingRanges, HoldNoValueThatGivesPosesThatAreNoNumbers) {
    RandomStream random{1};
    for_each_setting(filter_setting_list(), [&](const std::string& path, const Setting& setting) {
        if (!is_number(setting) || setting.key == "most_memory_mib") {
            return;
        }
        std::string pointer = "/" + path;
        std::replace(pointer.begin(), pointer.end(), '.', '/');
        for (const double number : {least_of(setting), most_of(setting), drawn(setting, random)}) {
            Json json = few_particles_of(method_of(path));
            json[Json::json_pointer(pointer)] = value_of(setting, number);
            expect_finite(json, path + " = " + json.at(Json::json_pointer(pointer)).dump());
        }
    });
}

/// Draws all settings at once. The lattice of `correlative` is left out, because a large one takes minutes.
TEST(SettingRanges, HoldNoValuesThatTogetherGivePosesThatAreNoNumbers) {
    RandomStream random{2};
    std::size_t tried = 0;
    for (int draw = 0; draw < 60; ++draw) {
        const std::array<const char*, 4> methods{"anti-degeneracy", "paper-strategies-on-ours", "rbpf", "fisher-gate"};
        Json json = few_particles_of(methods.at(random.index(methods.size())));
        if (random.uniform() < 0.5) {
            json["trust"] = "information";
            json["odometry"] = random.uniform() < 0.5 ? "learnt" : "as-logged";
            json["detector"] = "always";
        }
        for_each_setting(filter_setting_list(), [&](const std::string& path, const Setting& setting) {
            if (is_number(setting) && setting.key != "most_memory_mib" && !path.starts_with("correlative")) {
                std::string pointer = "/" + path;
                std::replace(pointer.begin(), pointer.end(), '.', '/');
                json[Json::json_pointer(pointer)] = value_of(setting, drawn(setting, random));
            }
        });
        try {
            (void)filter_settings_from_json(json);
        } catch (const UsageError&) {
            continue;  // for example a range of more cells than the matcher can count
        }
        ++tried;
        expect_finite(json, json.dump());
    }
    EXPECT_GT(tried, 20U);
}

}  // namespace
}  // namespace ddtool
