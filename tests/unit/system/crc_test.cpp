#include "system/crc.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace ddtool {
namespace {

auto bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

TEST(Crc, Crc32CIsThatOfTheSpecification) {
    // The values of RFC 3720, section B.4, and the check value in the catalogue of parametrised CRC algorithms.
    EXPECT_EQ(crc32c_of(bytes(std::string(32, '\0'))), 0x8a9136aaU);
    EXPECT_EQ(crc32c_of(bytes(std::string(32, '\xff'))), 0x62a8ab43U);
    EXPECT_EQ(crc32c_of(bytes("123456789")), 0xe3069283U);
    EXPECT_EQ(crc32c_of({}), 0U);
}

TEST(Crc, Crc32GoesOnFromTheBytesBefore) {
    EXPECT_EQ(crc32_of(bytes("6789"), crc32_of(bytes("12345"))), crc32_of(bytes("123456789")));
    EXPECT_EQ(crc32_of(bytes("123456789")), 0xcbf43926U);
}

}  // namespace
}  // namespace ddtool
