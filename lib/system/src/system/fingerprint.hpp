#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ddtool {

/// FNV-1a over 64 bits (Fowler, Noll, Vo; RFC 9923): tells results of different configurations apart, the same on
/// every machine. No protection against malice.
class Fingerprint {
public:
    Fingerprint& add(std::string_view bytes);
    /// The bits of the number.
    Fingerprint& add(double value);
    [[nodiscard]] std::uint64_t value() const { return state_; }
    /// 16 hexadecimal digits.
    [[nodiscard]] std::string hex() const;

private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// Of a file's content; "unreadable" for a file that is not there, so that one that appears later makes a difference.
std::string file_fingerprint(const std::filesystem::path& path);

}  // namespace ddtool
