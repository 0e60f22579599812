#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

const NpyFormat& samples_format() {
    static const NpyFormat format{
        "[('stamp_ns', '<i8'), ('update', '<u8'), ('first_particle', '<u8'), ('odometry_motion', '<f8', (3,)), "
        "('true_pose', '<f8', (3,)), ('information', '<f8', (6,)), ('range_sd_m', '<f8'), ('weak_sd_m', '<f8'), "
        "('weak_direction_rad', '<f8'), ('strong_sd_m', '<f8'), ('odometry_sd_m', '<f8'), "
        "('dispersion', '<f8', (4,)), ('source', '<u4'), ('run', '<u4'), ('particle_count', '<u4'), "
        "('label', '<i2', (2,)), ('part', '<i2', (2, 2))]",
        0};
    return format;
}

const NpyFormat& particles_format() {
    static const NpyFormat format{"'<f8'", 13};
    return format;
}

}  // namespace ddtool::dataset
