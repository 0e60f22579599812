#include "logs/messages/ros2_schema.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace ddtool {
namespace {

struct Definition {
    std::string_view type;  ///< in the form that field definitions use: package/Type
    std::string_view text;
};

constexpr std::array<Definition, 44> definitions{{
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    {"std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride\n"},
    {"std_msgs/MultiArrayLayout", "std_msgs/MultiArrayDimension[] dim\nuint32 data_offset\n"},
    {"std_msgs/Float64MultiArray", "std_msgs/MultiArrayLayout layout\nfloat64[] data\n"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Quaternion", "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"},
    {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
    {"geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
    {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
    {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
    {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
    {"geometry_msgs/PoseWithCovarianceStamped", "std_msgs/Header header\ngeometry_msgs/PoseWithCovariance pose\n"},
    {"geometry_msgs/PoseArray", "std_msgs/Header header\ngeometry_msgs/Pose[] poses\n"},
    {"geometry_msgs/TransformStamped",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
    {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
    {"sensor_msgs/LaserScan",
     "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
     "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
     "float32[] ranges\nfloat32[] intensities\n"},
    {"sensor_msgs/Imu",
     "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
     "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
     "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n"},
    {"sensor_msgs/PointField", "string name\nuint32 offset\nuint8 datatype\nuint32 count\n"},
    {"sensor_msgs/PointCloud2",
     "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\nbool is_bigendian\n"
     "uint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n"},
    {"nav_msgs/Odometry",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
     "geometry_msgs/TwistWithCovariance twist\n"},
    {"nav_msgs/Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n"},
    {"nav_msgs/OccupancyGrid", "std_msgs/Header header\nnav_msgs/MapMetaData info\nint8[] data\n"},
    {"nav_msgs/MapMetaData",
     "builtin_interfaces/Time map_load_time\nfloat32 resolution\nuint32 width\nuint32 height\n"
     "geometry_msgs/Pose origin\n"},
    {"diagnostic_msgs/KeyValue", "string key\nstring value\n"},
    {"diagnostic_msgs/DiagnosticStatus",
     "byte level\nstring name\nstring message\nstring hardware_id\ndiagnostic_msgs/KeyValue[] values\n"},
    {"diagnostic_msgs/DiagnosticArray", "std_msgs/Header header\ndiagnostic_msgs/DiagnosticStatus[] status\n"},
    {"rosgraph_msgs/Clock", "builtin_interfaces/Time clock\n"},
    {"rmw_dds_common/Gid", "uint8[16] data\n"},
    {"rmw_dds_common/NodeEntitiesInfo",
     "string<=256 node_namespace\nstring<=256 node_name\nrmw_dds_common/Gid[] reader_gid_seq\n"
     "rmw_dds_common/Gid[] writer_gid_seq\n"},
    {"rmw_dds_common/ParticipantEntitiesInfo",
     "rmw_dds_common/Gid gid\nrmw_dds_common/NodeEntitiesInfo[] node_entities_info_seq\n"},
    {"geometry_msgs/Pose2D", "float64 x\nfloat64 y\nfloat64 theta\n"},
    {"ddtool_msgs/SnapshotParticle",
     "geometry_msgs/Pose2D pose\ngeometry_msgs/Pose2D matched_motion\ngeometry_msgs/Pose2D predicted_motion\n"
     "float64 log_likelihood\nfloat64 log_likelihood_increment\nfloat64 match_score\nfloat64 weight\n"},
    {"ddtool_msgs/Degeneracy",
     "builtin_interfaces/Time stamp\nfloat64 degree\nfloat64 dispersion\nfloat64 major_variance\n"
     "float64 minor_variance\nfloat64 major_direction\nfloat64 corrected\nuint32 resampled\n"},
    {"ddtool_msgs/ParticleSnapshot",
     "builtin_interfaces/Time stamp\nuint64 update\ngeometry_msgs/Pose2D odometry_motion\nfloat64 degeneracy\n"
     "ddtool_msgs/SnapshotParticle[] particles\n"},
    {"ddtool_msgs/MapHeader",
     "uint32 format\nstring program\nstring settings\nfloat64 cell_size\nint32 hit_step\nint32 free_step\n"
     "int32 min_log_odds\nint32 max_log_odds\n"},
    {"ddtool_msgs/MapScan",
     "builtin_interfaces/Time stamp\nuint32 drive\ngeometry_msgs/Pose2D odometry\nfloat64 duration\nfloat64 degree\n"
     "float64[] lidars\nuint32[] beginnings\nfloat64 unit\nint16[] x\nint16[] y\nint16[] normal\nuint8[] along\n"
     "uint8[] order_gap\n"},
    {"ddtool_msgs/MapDrive", "string log\nuint32 has_odometry\nfloat64[] odometry\n"},
    {"ddtool_msgs/MapEdge",
     "uint32 kind\nuint32 from\nuint32 to\ngeometry_msgs/Pose2D measured\nfloat64[] information\nfloat64 weight\n"},
    {"ddtool_msgs/MapGraph", "geometry_msgs/Pose2D[] poses\nddtool_msgs/MapEdge[] edges\n"},
    {"ddtool_msgs/MapTile", "int32 column\nint32 row\nint8[] log_odds\nint8[] means\n"},
    {"ddtool_msgs/MapEnd", "uint64 scans\nuint64 drives\nuint64 tiles\n"},
}};

std::string_view definition_of(std::string_view type) {
    const auto* found = std::find_if(definitions.begin(), definitions.end(),
                                     [&](const Definition& definition) { return definition.type == type; });
    return found == definitions.end() ? std::string_view{} : found->text;
}

/// Adds a type, and then, depth first, the types of its fields that are messages and not in the list yet.
void collect(std::string_view type, std::vector<std::string_view>& types) {
    std::string_view text = definition_of(type);
    if (text.empty() || std::find(types.begin(), types.end(), type) != types.end()) {
        return;
    }
    types.push_back(type);
    while (!text.empty()) {
        collect(text.substr(0, text.find_first_of(" [")), types);
        text.remove_prefix(text.find('\n') + 1);
    }
}

}  // namespace

std::string ros2_schema(std::string_view type_name) {
    std::string type(type_name);
    const std::size_t middle = type.find("/msg/");
    type.erase(std::min(middle, type.size()), middle == std::string::npos ? 0 : std::string_view("/msg").size());
    std::vector<std::string_view> types;
    collect(type, types);
    std::string schema;
    for (const std::string_view used : types) {
        if (used != type) {
            schema += std::string(80, '=') + "\nMSG: " + std::string(used) + "\n";
        }
        schema += definition_of(used);
    }
    return schema;
}

}  // namespace ddtool
