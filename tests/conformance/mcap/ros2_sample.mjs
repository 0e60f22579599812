// Writes one file with the ROS 2 messages that ddtool reads, encoded from their definitions by
// @foxglove/rosmsg2-serialization.

import { parse } from "@foxglove/rosmsg";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import { McapWriter } from "@mcap/core";
import { compressChunk } from "./compression.mjs";
import { MemoryFile } from "./memory_file.mjs";

// The fields of the messages in common_interfaces and geometry2, without their comments.
const fields = {
  "builtin_interfaces/Time": ["int32 sec", "uint32 nanosec"],
  "std_msgs/Header": ["builtin_interfaces/Time stamp", "string frame_id"],
  "geometry_msgs/Point": ["float64 x", "float64 y", "float64 z"],
  "geometry_msgs/Vector3": ["float64 x", "float64 y", "float64 z"],
  "geometry_msgs/Quaternion": ["float64 x", "float64 y", "float64 z", "float64 w"],
  "geometry_msgs/Pose": ["geometry_msgs/Point position", "geometry_msgs/Quaternion orientation"],
  "geometry_msgs/PoseStamped": ["std_msgs/Header header", "geometry_msgs/Pose pose"],
  "geometry_msgs/PoseWithCovariance": ["geometry_msgs/Pose pose", "float64[36] covariance"],
  "geometry_msgs/Twist": ["geometry_msgs/Vector3 linear", "geometry_msgs/Vector3 angular"],
  "geometry_msgs/TwistWithCovariance": ["geometry_msgs/Twist twist", "float64[36] covariance"],
  "geometry_msgs/Transform": ["geometry_msgs/Vector3 translation", "geometry_msgs/Quaternion rotation"],
  "geometry_msgs/TransformStamped": [
    "std_msgs/Header header",
    "string child_frame_id",
    "geometry_msgs/Transform transform",
  ],
  "tf2_msgs/TFMessage": ["geometry_msgs/TransformStamped[] transforms"],
  "nav_msgs/Odometry": [
    "std_msgs/Header header",
    "string child_frame_id",
    "geometry_msgs/PoseWithCovariance pose",
    "geometry_msgs/TwistWithCovariance twist",
  ],
  "sensor_msgs/LaserScan": [
    "std_msgs/Header header",
    "float32 angle_min",
    "float32 angle_max",
    "float32 angle_increment",
    "float32 time_increment",
    "float32 scan_time",
    "float32 range_min",
    "float32 range_max",
    "float32[] ranges",
    "float32[] intensities",
  ],
};

/** The types that a type's definition needs, each once, itself first. */
function dependencies(type, found = new Set()) {
  found.add(type);
  for (const field of fields[type]) {
    const used = field.split(/[ [\]]/)[0];
    if (used in fields && !found.has(used)) {
      dependencies(used, found);
    }
  }
  return [...found];
}

/** The schema in the form of MCAP's registry: the type's definition, then the others after a line of "=". */
function schemaOf(type) {
  return dependencies(type)
    .map((name, index) => (index > 0 ? `${"=".repeat(80)}\nMSG: ${name}\n` : "") + fields[name].join("\n") + "\n")
    .join("");
}

const header = (frame, milliseconds) => ({
  stamp: { sec: 1700000000, nanosec: milliseconds * 1_000_000 + 7 },
  frame_id: frame,
});
const pose = (x, y, angle) => ({
  position: { x, y, z: 0 },
  orientation: { x: 0, y: 0, z: Math.sin(angle / 2), w: Math.cos(angle / 2) },
});
const transform = (parent, child, milliseconds, { position, orientation }) => ({
  header: header(parent, milliseconds),
  child_frame_id: child,
  transform: { translation: position, rotation: orientation },
});
const covariance = Array.from({ length: 36 }, (_, index) => index / 4);

export const ros2Messages = [
  {
    topic: "/tf_static",
    type: "tf2_msgs/TFMessage",
    message: { transforms: [transform("base_link", "laser", 0, pose(0.25, -0.125, 0.5))] },
  },
  {
    topic: "/tf",
    type: "tf2_msgs/TFMessage",
    message: {
      transforms: [
        transform("map", "odom", 1, pose(1, 2, -0.25)),
        transform("odom", "base_link", 2, pose(-3.5, 0.75, 3)),
      ],
    },
  },
  {
    topic: "/odom",
    type: "nav_msgs/Odometry",
    message: {
      header: header("odom", 3),
      child_frame_id: "base_link",
      pose: { pose: pose(4.5, -1.5, 1.25), covariance },
      twist: {
        twist: { linear: { x: 0.5, y: 0.25, z: 0 }, angular: { x: 0, y: 0, z: -0.125 } },
        covariance: [...covariance].reverse(),
      },
    },
  },
  {
    topic: "/truth",
    type: "geometry_msgs/PoseStamped",
    message: { header: header("map", 4), pose: pose(6.25, 7.5, -2) },
  },
  {
    topic: "/scan",
    type: "sensor_msgs/LaserScan",
    message: {
      header: header("laser", 5),
      angle_min: -0.5,
      angle_max: 0.5,
      angle_increment: 0.25,
      time_increment: 0.0625,
      scan_time: 0.125,
      range_min: 0.25,
      range_max: 16,
      ranges: [1.5, 0, 20.25, 2.75, 0.125],
      intensities: [10, 20],
    },
  },
];

/** The file that holds them, one message a channel, a millisecond apart. */
export async function writeRos2Sample() {
  const file = new MemoryFile();
  const writer = new McapWriter({ writable: file, compressChunk: compressChunk.zstd });
  await writer.start({ profile: "ros2", library: "@mcap/core" });
  for (const [index, { topic, type, message }] of ros2Messages.entries()) {
    const schema = schemaOf(type);
    const [packageName, name] = type.split("/");
    const schemaId = await writer.registerSchema({
      name: `${packageName}/msg/${name}`,
      encoding: "ros2msg",
      data: new TextEncoder().encode(schema),
    });
    const channelId = await writer.registerChannel({ topic, schemaId, messageEncoding: "cdr", metadata: new Map() });
    const time = 1_700_000_000_000_000_000n + BigInt(index) * 1_000_000n;
    const data = new MessageWriter(parse(schema, { ros2: true })).writeMessage(message);
    await writer.addMessage({ channelId, sequence: 0, logTime: time, publishTime: time, data });
  }
  await writer.end();
  return file.bytes();
}
