#include "maps/ply_file.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <ostream>

#include "system/atomic_file.hpp"

namespace ddtool::maps {

static_assert(std::endian::native == std::endian::little, "the file is written as the numbers lie in memory");

void write_ply(const std::filesystem::path& file, const SavedMap& map) {
    std::size_t points = 0;
    for (const MapNode& node : map.nodes) {
        points += node.scan.points.size();
    }
    write_file(file, [&](std::ostream& out) {
        out << "ply\nformat binary_little_endian 1.0\ncomment made by ddtool\nelement vertex " << points
            << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\n"
               "property float nz\nproperty int scan\nend_header\n";
        std::int32_t number = 0;
        for (const MapNode& node : map.nodes) {
            const ScanPoints scan = node.scan.points.unpacked();
            const double c = std::cos(node.pose.theta_rad);
            const double s = std::sin(node.pose.theta_rad);
            for (std::size_t i = 0; i < scan.size(); ++i) {
                const Point2 at = node.pose * Point2{double{scan.x_m[i]}, double{scan.y_m[i]}};
                const std::array<float, 6> values{static_cast<float>(at.x_m),
                                                  static_cast<float>(at.y_m),
                                                  0.0F,
                                                  static_cast<float>(c * scan.normal_x[i] - s * scan.normal_y[i]),
                                                  static_cast<float>(s * scan.normal_x[i] + c * scan.normal_y[i]),
                                                  0.0F};
                out.write(reinterpret_cast<const char*>(values.data()), sizeof values);
                out.write(reinterpret_cast<const char*>(&number), sizeof number);
            }
            ++number;
        }
    });
}

}  // namespace ddtool::maps
