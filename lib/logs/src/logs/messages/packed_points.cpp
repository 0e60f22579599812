#include "logs/messages/packed_points.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <utility>

namespace ddtool {
namespace {

std::size_t bytes_of(PointNumber number) {
    switch (number) {
        case PointNumber::int8:
        case PointNumber::uint8:
            return 1;
        case PointNumber::int16:
        case PointNumber::uint16:
            return 2;
        case PointNumber::int32:
        case PointNumber::uint32:
        case PointNumber::float32:
            return 4;
        case PointNumber::float64:
            return 8;
        default:
            return 0;
    }
}

template <typename Number>
float number_in(const std::byte* bytes, bool big_endian) {
    std::array<std::byte, sizeof(Number)> raw{};
    std::memcpy(raw.data(), bytes, raw.size());
    if (big_endian) {
        std::ranges::reverse(raw);
    }
    Number value{};
    std::memcpy(&value, raw.data(), raw.size());
    return static_cast<float>(value);
}

float coordinate(const std::byte* point, const PackedField& field, bool big_endian) {
    const std::byte* bytes = point + field.offset;
    switch (field.number) {
        case PointNumber::int8:
            return number_in<std::int8_t>(bytes, big_endian);
        case PointNumber::uint8:
            return number_in<std::uint8_t>(bytes, big_endian);
        case PointNumber::int16:
            return number_in<std::int16_t>(bytes, big_endian);
        case PointNumber::uint16:
            return number_in<std::uint16_t>(bytes, big_endian);
        case PointNumber::int32:
            return number_in<std::int32_t>(bytes, big_endian);
        case PointNumber::uint32:
            return number_in<std::uint32_t>(bytes, big_endian);
        case PointNumber::float32:
            return number_in<float>(bytes, big_endian);
        case PointNumber::float64:
            return number_in<double>(bytes, big_endian);
        default:
            return std::numeric_limits<float>::quiet_NaN();
    }
}

std::string names_of_fields(const std::vector<PackedField>& fields) {
    std::string names;
    for (const PackedField& field : fields) {
        names += (names.empty() ? "" : ", ") + field.name;
    }
    return names.empty() ? "none" : names;
}

/// Finds the fields of the coordinates. Returns why that fails; empty where it does not.
std::string find_axes(const PackedPoints& packed, std::array<PackedField, 3>& axes) {
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const std::string name(1, "xyz"[axis]);
        const auto field = std::ranges::find(packed.fields, name, &PackedField::name);
        if (field == packed.fields.end()) {
            return "without the field " + name + " (its fields: " + names_of_fields(packed.fields) + ")";
        }
        const std::size_t size = bytes_of(field->number);
        if (size == 0 || std::uint64_t{field->offset} + size > packed.point_step) {
            return "whose field " + name + " is no number within its points (type " +
                   std::to_string(static_cast<int>(field->number)) + ", offset " + std::to_string(field->offset) +
                   ", points of " + std::to_string(packed.point_step) + " bytes)";
        }
        axes[axis] = *field;
    }
    return "";
}

}  // namespace

void unpack_into(CloudReading& reading, const PackedPoints& packed) {
    const std::uint64_t points = packed.rows * packed.points_of_row;
    if (points == 0) {
        return;
    }
    std::array<PackedField, 3> axes;
    reading.fault = find_axes(packed, axes);
    if (!reading.fault.empty()) {
        return;
    }
    // The numbers in the messages have 32 bits, so that no product of two exceeds 64 bits.
    const std::uint64_t row_bytes = packed.points_of_row * packed.point_step;
    const std::uint64_t row_step = packed.row_step == 0 ? row_bytes : packed.row_step;
    if (row_step < row_bytes || row_bytes > packed.data.size() ||
        packed.rows - 1 > (packed.data.size() - row_bytes) / row_step) {
        reading.fault = "of " + std::to_string(packed.data.size()) + " bytes; expected " + std::to_string(packed.rows) +
                        " rows, " + std::to_string(row_step) + " bytes apart, of " +
                        std::to_string(packed.points_of_row) + " points of " + std::to_string(packed.point_step) +
                        " bytes";
        return;
    }
    reading.points_m.reserve(points);
    for (std::uint64_t row = 0; row < packed.rows; ++row) {
        const std::byte* point = packed.data.data() + row * row_step;
        for (std::uint64_t i = 0; i < packed.points_of_row; ++i, point += packed.point_step) {
            const Eigen::Vector3f place(coordinate(point, axes[0], packed.big_endian),
                                        coordinate(point, axes[1], packed.big_endian),
                                        coordinate(point, axes[2], packed.big_endian));
            if (place.allFinite()) {
                reading.points_m.push_back(place);
            }
        }
    }
}

}  // namespace ddtool
