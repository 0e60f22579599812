#include "train/event_file.hpp"

#include <bit>
#include <concepts>
#include <fstream>

#include "system/atomic_file.hpp"
#include "system/crc.hpp"
#include "tensorboard_event.pb.h"

namespace ddtool::train {
namespace {

void append_little_endian(std::string& bytes, std::unsigned_integral auto number) {
    for (std::size_t byte = 0; byte < sizeof(number); ++byte) {
        bytes += static_cast<char>(number >> (8 * byte) & 0xFFU);
    }
}

/// The masked CRC of the TFRecord format. Masking is useful where the data contain CRCs themselves, because computing a
/// CRC of bytes with a CRC among them is problematic.
std::uint32_t masked_crc(std::string_view bytes) {
    return std::rotr(crc32c_of(std::as_bytes(std::span(bytes))), 15) + 0xa282ead8U;
}

void append_record(std::string& file, const tensorboard::Event& event) {
    const std::string content = event.SerializeAsString();
    std::string length;
    append_little_endian(length, std::uint64_t{content.size()});
    file += length;
    append_little_endian(file, masked_crc(length));
    file += content;
    append_little_endian(file, masked_crc(content));
}

tensorboard::Event event_of(const StepScalars& step) {
    tensorboard::Event event;
    event.set_wall_time(step.wall_time_s);
    event.set_step(step.step);
    for (const auto& [tag, value] : step.values) {
        tensorboard::Summary::Value& entry = *event.mutable_summary()->add_value();
        entry.set_tag(tag);
        entry.set_simple_value(static_cast<float>(value));
    }
    return event;
}

void append_to_file(const std::filesystem::path& path, std::string_view bytes) {
    std::ofstream out(path, std::ios::binary | std::ios::app);
    if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush()) {
        throw OutputError(path.string() + ": cannot be written to its end");
    }
}

}  // namespace

std::string event_file_of(std::span<const StepScalars> steps) {
    tensorboard::Event version;
    version.set_wall_time(steps.empty() ? 0.0 : steps.front().wall_time_s);
    version.set_file_version("brain.Event:2");
    std::string file;
    append_record(file, version);
    for (const StepScalars& step : steps) {
        append_record(file, event_of(step));
    }
    return file;
}

void write_event_file(const std::filesystem::path& path, std::span<const StepScalars> steps) {
    const std::string file = event_file_of(steps);
    const std::string before = std::filesystem::exists(path) ? read_file(path) : "";
    if (!before.empty() && file.starts_with(before)) {
        append_to_file(path, std::string_view(file).substr(before.size()));
    } else {
        write_file(path, file);
    }
}

}  // namespace ddtool::train
