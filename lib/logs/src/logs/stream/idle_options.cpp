#include "logs/stream/idle_options.hpp"

namespace ddtool {

std::vector<std::string> options_without_effect(const LogOptions& options, const UsedOfLog& used) {
    struct Idle {
        const char* option;
        bool is_idle;
        const char* reason;
    };
    const char* const no_clouds = "no point clouds are used";
    const char* const no_odometry = "no odometry is used";
    const bool names_imu = !options.imu_topic.empty() && options.imu_topic != "none";
    std::vector<std::string> lines;
    for (const Idle& each : {
             Idle{"--height", options.height.has_value() && !used.clouds, no_clouds},
             Idle{"log.cloud_beams", options.cloud_beams > 0 && !used.clouds, no_clouds},
             Idle{"log.echo", options.strongest_echo && !used.echoes,
                  "no scans with several echoes of a beam are used"},
             Idle{"--odom-path", options.odom_path > 0 && !used.odometry, no_odometry},
             Idle{"--odom-delay", options.odom_delay_s.has_value() && !used.odometry, no_odometry},
             Idle{"--imu-topic", names_imu && !used.odometry,
                  "the turns of an inertial sensor are used together with odometry, and no odometry is used"},
         }) {
        if (each.is_idle) {
            lines.push_back(std::string(each.option) + " has no effect: " + each.reason);
        }
    }
    return lines;
}

}  // namespace ddtool
