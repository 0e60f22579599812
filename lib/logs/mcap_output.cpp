#include "logs/mcap_output.hpp"

#include <cerrno>
#include <cstring>
#include <string>

#include "base/crc.hpp"

namespace ddtool {
namespace {

void require(const std::ostream& stream, const std::filesystem::path& path, const char* doing) {
    if (!stream) {
        throw OutputError(path.string() + ": cannot " + doing + ": " + std::strerror(errno));
    }
}

}  // namespace

McapOutput::McapOutput(const std::filesystem::path& path) : path_(path), file_(path) {
    errno = 0;
    stream_.open(file_.part(), std::ios::binary);
    require(stream_, path_, "create");
}

void McapOutput::put(std::span<const std::byte> bytes) {
    stream_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    require(stream_, path_, "write");
    offset_ += bytes.size();
    crc_ = crc32_of(bytes, crc_);
}

void McapOutput::put_record(McapOpcode opcode, const McapFieldWriter& content) {
    put(McapFieldWriter().put_record_header(opcode, content.size()).bytes());
    put(content.bytes());
}

void McapOutput::commit() {
    stream_.close();
    require(stream_, path_, "write");
    file_.commit();
}

}  // namespace ddtool
