#include "logs/containers/mcap_compression.hpp"

#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool {

std::string_view mcap_compression_name(Compression compression) {
    switch (compression) {
        case Compression::none:
            return "";
        case Compression::lz4:
            return "lz4";
        case Compression::zstd:
            return "zstd";
        case Compression::bzip2:
        case Compression::gzip:
            break;
    }
    throw Error("MCAP: no " + std::string(name_of(compression)) + " in its chunks; expected lz4, zstd or none");
}

std::optional<Compression> mcap_compression_of(std::string_view name) {
    for (const auto compression : {Compression::none, Compression::lz4, Compression::zstd}) {
        if (name == mcap_compression_name(compression)) {
            return compression;
        }
    }
    return std::nullopt;
}

}  // namespace ddtool
