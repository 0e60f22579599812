#include "logs/containers/mcap_output.hpp"

#include "system/crc.hpp"

namespace ddtool {

void McapOutput::put(std::span<const std::byte> bytes) {
    file_.write([&](std::ostream& out) {
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    });
    offset_ += bytes.size();
    crc_ = crc32_of(bytes, crc_);
}

void McapOutput::put_record(McapOpcode opcode, const McapFieldWriter& content) {
    put(McapFieldWriter().put_record_header(opcode, content.size()).bytes());
    put(content.bytes());
}

}  // namespace ddtool
