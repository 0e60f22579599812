#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ddtool {

/// FNV-1a over 64 bits (Fowler, Noll, Vo; RFC 9923): it tells results of different configurations apart, and is the
/// same on every machine. It does not protect against somebody who wants two contents to have the same fingerprint.
class Fingerprint {
public:
    Fingerprint& add(std::string_view bytes);
    /// Adds the bits of the number, so that any two different bit patterns count as different.
    Fingerprint& add(double value);
    [[nodiscard]] std::uint64_t value() const { return state_; }
    /// 16 hexadecimal digits.
    [[nodiscard]] std::string hex() const;

private:
    std::uint64_t state_ = 0xcbf29ce484222325U;
};

/// The fingerprint of a file's content in the form of Fingerprint::hex(). Returns "unreadable" if the file cannot be
/// opened, so that a file that appears later changes the result.
std::string file_fingerprint(const std::filesystem::path& path);

}  // namespace ddtool
