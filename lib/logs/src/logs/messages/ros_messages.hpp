#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// The ROS messages that are read and written, as plain structs named, after "Ros", and laid out as their definitions
/// say (https://docs.ros.org, common_interfaces). Each lists its fields once, in the order of its definition, for all
/// codecs: fields(message, archive) calls archive(field, ...). Lengths are metres, angles radians.
namespace ddtool {

/// Serialised as seconds and nanoseconds.
struct RosTime {
    std::int64_t ns = 0;
};

struct RosHeader {
    static constexpr const char* type_name = "std_msgs/msg/Header";
    RosTime stamp;
    std::string frame_id;

    static void fields(auto& message, auto& archive) { archive(message.stamp, message.frame_id); }
};

/// geometry_msgs Point too, which has the same fields.
struct RosVector3 {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    static void fields(auto& message, auto& archive) { archive(message.x, message.y, message.z); }
};

struct RosQuaternion {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double w = 1.0;

    static void fields(auto& message, auto& archive) { archive(message.x, message.y, message.z, message.w); }
};

/// geometry_msgs Transform too, which has the same fields: translation and rotation.
struct RosPose {
    RosVector3 position;
    RosQuaternion orientation;

    static void fields(auto& message, auto& archive) { archive(message.position, message.orientation); }
};

struct RosTransformStamped {
    RosHeader header;
    std::string child_frame_id;
    RosPose transform;  ///< header.frame_id from child_frame_id

    static void fields(auto& message, auto& archive) {
        archive(message.header, message.child_frame_id, message.transform);
    }
};

struct RosTFMessage {
    static constexpr const char* type_name = "tf2_msgs/msg/TFMessage";
    std::vector<RosTransformStamped> transforms;

    static void fields(auto& message, auto& archive) { archive(message.transforms); }
};

/// The fields of LaserScan and MultiEchoLaserScan, which differ in what a ray has.
template <typename Ray>
struct RosScanOf {
    RosHeader header;  ///< stamp of the first ray
    float angle_min = 0.0F;
    float angle_max = 0.0F;
    float angle_increment = 0.0F;
    float time_increment = 0.0F;  ///< seconds
    float scan_time = 0.0F;       ///< seconds
    float range_min = 0.0F;
    float range_max = 0.0F;
    std::vector<Ray> ranges;
    std::vector<Ray> intensities;  ///< of the same echoes, or empty

    static void fields(auto& message, auto& archive) {
        archive(message.header, message.angle_min, message.angle_max, message.angle_increment, message.time_increment,
                message.scan_time, message.range_min, message.range_max, message.ranges, message.intensities);
    }
};

struct RosLaserScan : RosScanOf<float> {
    static constexpr const char* type_name = "sensor_msgs/msg/LaserScan";
};

struct RosImu {
    static constexpr const char* type_name = "sensor_msgs/msg/Imu";
    RosHeader header;
    RosQuaternion orientation;
    std::array<double, 9> orientation_covariance{};
    RosVector3 angular_velocity;  ///< rad/s, in the frame of the header
    /// Row by row. -1 in front: the sensor does not measure this.
    std::array<double, 9> angular_velocity_covariance{};
    RosVector3 linear_acceleration;  ///< m/s^2; at rest it points upwards
    std::array<double, 9> linear_acceleration_covariance{};

    static void fields(auto& message, auto& archive) {
        archive(message.header, message.orientation, message.orientation_covariance, message.angular_velocity,
                message.angular_velocity_covariance, message.linear_acceleration,
                message.linear_acceleration_covariance);
    }
};

/// The ranges, or the intensities, that one ray has, from the nearest echo to the farthest.
struct RosLaserEcho {
    std::vector<float> echoes;

    static void fields(auto& message, auto& archive) { archive(message.echoes); }
};

struct RosMultiEchoLaserScan : RosScanOf<RosLaserEcho> {
    static constexpr const char* type_name = "sensor_msgs/msg/MultiEchoLaserScan";
};

struct RosPointField {
    std::string name;
    std::uint32_t offset = 0;   ///< bytes from the start of the point
    std::uint8_t datatype = 0;  ///< 1 to 8: int8, uint8, int16, uint16, int32, uint32, float32, float64
    std::uint32_t count = 1;

    static void fields(auto& message, auto& archive) {
        archive(message.name, message.offset, message.datatype, message.count);
    }
};

/// The flags are bools in the definition; as numbers they may hold any byte of a damaged message.
struct RosPointCloud2 {
    static constexpr const char* type_name = "sensor_msgs/msg/PointCloud2";
    RosHeader header;
    std::uint32_t height = 0;
    std::uint32_t width = 0;  ///< points in a row
    std::vector<RosPointField> point_fields;
    std::uint8_t is_bigendian = 0;
    std::uint32_t point_step = 0;  ///< bytes
    std::uint32_t row_step = 0;    ///< bytes
    std::vector<std::uint8_t> data;
    std::uint8_t is_dense = 0;  ///< whether no point is NaN

    static void fields(auto& message, auto& archive) {
        archive(message.header, message.height, message.width, message.point_fields, message.is_bigendian,
                message.point_step, message.row_step, message.data, message.is_dense);
    }
};

struct RosOdometry {
    static constexpr const char* type_name = "nav_msgs/msg/Odometry";
    RosHeader header;
    std::string child_frame_id;
    RosPose pose;  ///< header.frame_id from child_frame_id
    std::array<double, 36> pose_covariance{};
    RosVector3 linear_velocity;   ///< m/s, in the child frame
    RosVector3 angular_velocity;  ///< rad/s, in the child frame
    std::array<double, 36> velocity_covariance{};

    static void fields(auto& message, auto& archive) {
        archive(message.header, message.child_frame_id, message.pose, message.pose_covariance, message.linear_velocity,
                message.angular_velocity, message.velocity_covariance);
    }
};

struct RosPoseStamped {
    static constexpr const char* type_name = "geometry_msgs/msg/PoseStamped";
    RosHeader header;
    RosPose pose;

    static void fields(auto& message, auto& archive) { archive(message.header, message.pose); }
};

struct RosPoseWithCovarianceStamped {
    static constexpr const char* type_name = "geometry_msgs/msg/PoseWithCovarianceStamped";
    RosHeader header;
    RosPose pose;
    std::array<double, 36> covariance{};  ///< row by row: x, y, z, and turns about these axes

    static void fields(auto& message, auto& archive) { archive(message.header, message.pose, message.covariance); }
};

struct RosTwistStamped {
    static constexpr const char* type_name = "geometry_msgs/msg/TwistStamped";
    RosHeader header;
    RosVector3 linear;   ///< m/s
    RosVector3 angular;  ///< rad/s

    static void fields(auto& message, auto& archive) { archive(message.header, message.linear, message.angular); }
};

struct RosTwistWithCovarianceStamped {
    static constexpr const char* type_name = "geometry_msgs/msg/TwistWithCovarianceStamped";
    RosTwistStamped twist;
    std::array<double, 36> covariance{};

    static void fields(auto& message, auto& archive) { archive(message.twist, message.covariance); }
};

struct RosPoseArray {
    static constexpr const char* type_name = "geometry_msgs/msg/PoseArray";
    RosHeader header;
    std::vector<RosPose> poses;

    static void fields(auto& message, auto& archive) { archive(message.header, message.poses); }
};

struct RosPath {
    static constexpr const char* type_name = "nav_msgs/msg/Path";
    RosHeader header;
    std::vector<RosPoseStamped> poses;

    static void fields(auto& message, auto& archive) { archive(message.header, message.poses); }
};

struct RosMultiArrayDimension {
    std::string label;
    std::uint32_t size = 0;
    std::uint32_t stride = 0;  ///< number of elements in this dimension and all inner ones

    static void fields(auto& message, auto& archive) { archive(message.label, message.size, message.stride); }
};

struct RosFloat64MultiArray {
    static constexpr const char* type_name = "std_msgs/msg/Float64MultiArray";
    std::vector<RosMultiArrayDimension> dimensions;  ///< outermost first
    std::uint32_t data_offset = 0;
    std::vector<double> data;

    static void fields(auto& message, auto& archive) { archive(message.dimensions, message.data_offset, message.data); }
};

struct RosOccupancyGrid {
    static constexpr const char* type_name = "nav_msgs/msg/OccupancyGrid";
    RosHeader header;
    RosTime map_load_time;
    float resolution = 0.0F;  ///< metres per cell
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    RosPose origin;                 ///< of the lower left corner of cell (0, 0)
    std::vector<std::int8_t> data;  ///< row by row from the origin: 0 free to 100 occupied, -1 unknown

    static void fields(auto& message, auto& archive) {
        archive(message.header, message.map_load_time, message.resolution, message.width, message.height,
                message.origin, message.data);
    }
};

struct RosKeyValue {
    std::string key;
    std::string value;

    static void fields(auto& message, auto& archive) { archive(message.key, message.value); }
};

struct RosDiagnosticStatus {
    static constexpr std::uint8_t ok = 0;
    static constexpr std::uint8_t warning = 1;
    static constexpr std::uint8_t error = 2;
    static constexpr std::uint8_t stale = 3;
    std::uint8_t level = ok;
    std::string name;  ///< of the part that is judged
    std::string message;
    std::string hardware_id;
    std::vector<RosKeyValue> values;

    static void fields(auto& message, auto& archive) {
        archive(message.level, message.name, message.message, message.hardware_id, message.values);
    }
};

struct RosDiagnosticArray {
    static constexpr const char* type_name = "diagnostic_msgs/msg/DiagnosticArray";
    RosHeader header;
    std::vector<RosDiagnosticStatus> status;

    static void fields(auto& message, auto& archive) { archive(message.header, message.status); }
};

struct RosClock {
    static constexpr const char* type_name = "rosgraph_msgs/msg/Clock";
    RosTime clock;

    static void fields(auto& message, auto& archive) { archive(message.clock); }
};

/// The identity of a DDS participant, reader or writer: its GUID, and in ROS 2 before Iron, which has 24 bytes, zeros.
template <std::size_t size>
struct RosGid {
    std::array<std::uint8_t, size> data{};

    static void fields(auto& message, auto& archive) { archive(message.data); }
};

template <std::size_t gid_bytes>
struct RosNodeEntities {
    std::string node_namespace;
    std::string node_name;
    std::vector<RosGid<gid_bytes>> readers;
    std::vector<RosGid<gid_bytes>> writers;

    static void fields(auto& message, auto& archive) {
        archive(message.node_namespace, message.node_name, message.readers, message.writers);
    }
};

/// Which nodes a DDS participant holds, and which readers and writers are theirs.
template <std::size_t gid_bytes>
struct RosParticipantEntities {
    static constexpr const char* type_name = "rmw_dds_common/msg/ParticipantEntitiesInfo";
    RosGid<gid_bytes> participant;
    std::vector<RosNodeEntities<gid_bytes>> nodes;

    static void fields(auto& message, auto& archive) { archive(message.participant, message.nodes); }
};

struct RosPose2D {
    double x = 0.0;
    double y = 0.0;
    double theta = 0.0;

    static void fields(auto& message, auto& archive) { archive(message.x, message.y, message.theta); }
};

/// Message types of ddtool, like RosParticleSnapshot below: docs/formats/snapshots.md.
struct RosSnapshotParticle {
    RosPose2D pose;
    RosPose2D matched_motion;
    RosPose2D predicted_motion;
    double log_likelihood = 0.0;
    double log_likelihood_increment = 0.0;
    double match_score = 0.0;
    double weight = 0.0;

    static void fields(auto& message, auto& archive) {
        archive(message.pose, message.matched_motion, message.predicted_motion, message.log_likelihood,
                message.log_likelihood_increment, message.match_score, message.weight);
    }
};

struct RosParticleSnapshot {
    static constexpr const char* type_name = "ddtool_msgs/msg/ParticleSnapshot";
    RosTime stamp;
    std::uint64_t update = 0;
    RosPose2D odometry_motion;
    double degeneracy = 0.0;
    std::vector<RosSnapshotParticle> particles;

    static void fields(auto& message, auto& archive) {
        archive(message.stamp, message.update, message.odometry_motion, message.degeneracy, message.particles);
    }
};

/// Messages of a saved map: docs/formats/map-file.md.
struct RosMapHeader {
    static constexpr const char* type_name = "ddtool_msgs/msg/MapHeader";
    std::uint32_t format = 0;
    std::string program;
    std::string settings;  ///< JSON
    double cell_size = 0.0;
    std::int32_t hit_step = 0;
    std::int32_t free_step = 0;
    std::int32_t min_log_odds = 0;
    std::int32_t max_log_odds = 0;

    static void fields(auto& message, auto& archive) {
        archive(message.format, message.program, message.settings, message.cell_size, message.hit_step,
                message.free_step, message.min_log_odds, message.max_log_odds);
    }
};

struct RosMapScan {
    static constexpr const char* type_name = "ddtool_msgs/msg/MapScan";
    RosTime stamp;
    std::uint32_t drive = 0;
    RosPose2D odometry;
    double duration = 0.0;
    double degree = 0.0;
    std::vector<double> lidars;             ///< x and y of each
    std::vector<std::uint32_t> beginnings;  ///< first point of each lidar but the first
    double unit = 0.0;
    std::vector<std::int16_t> x;
    std::vector<std::int16_t> y;
    std::vector<std::int16_t> normal;
    std::vector<std::uint8_t> along;
    std::vector<std::uint8_t> order_gap;

    static void fields(auto& message, auto& archive) {
        archive(message.stamp, message.drive, message.odometry, message.duration, message.degree, message.lidars,
                message.beginnings, message.unit, message.x, message.y, message.normal, message.along,
                message.order_gap);
    }
};

struct RosMapDrive {
    static constexpr const char* type_name = "ddtool_msgs/msg/MapDrive";
    std::string log;
    std::uint32_t has_odometry = 0;
    std::vector<double> odometry;

    static void fields(auto& message, auto& archive) { archive(message.log, message.has_odometry, message.odometry); }
};

struct RosMapEdge {
    std::uint32_t kind = 0;
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    RosPose2D measured;
    std::vector<double> information;  ///< xx, xy, xt, yy, yt, tt
    double weight = 0.0;

    static void fields(auto& message, auto& archive) {
        archive(message.kind, message.from, message.to, message.measured, message.information, message.weight);
    }
};

struct RosMapGraph {
    static constexpr const char* type_name = "ddtool_msgs/msg/MapGraph";
    std::vector<RosPose2D> poses;
    std::vector<RosMapEdge> edges;

    static void fields(auto& message, auto& archive) { archive(message.poses, message.edges); }
};

struct RosMapTile {
    static constexpr const char* type_name = "ddtool_msgs/msg/MapTile";
    std::int32_t column = 0;
    std::int32_t row = 0;
    std::vector<std::int8_t> log_odds;
    std::vector<std::int8_t> means;

    static void fields(auto& message, auto& archive) {
        archive(message.column, message.row, message.log_odds, message.means);
    }
};

struct RosMapEnd {
    static constexpr const char* type_name = "ddtool_msgs/msg/MapEnd";
    std::uint64_t scans = 0;
    std::uint64_t drives = 0;
    std::uint64_t tiles = 0;

    static void fields(auto& message, auto& archive) { archive(message.scans, message.drives, message.tiles); }
};

/// A message type of ddtool: docs/formats/results.md.
struct RosDegeneracy {
    static constexpr const char* type_name = "ddtool_msgs/msg/Degeneracy";
    RosTime stamp;
    double degree = 0.0;
    double dispersion = 0.0;
    double major_variance = 0.0;
    double minor_variance = 0.0;
    double major_direction = 0.0;
    double corrected = 0.0;
    std::uint32_t resampled = 0;

    static void fields(auto& message, auto& archive) {
        archive(message.stamp, message.degree, message.dispersion, message.major_variance, message.minor_variance,
                message.major_direction, message.corrected, message.resampled);
    }
};

}  // namespace ddtool
