#include "report/data_uri.hpp"

#include <gtest/gtest.h>

namespace ddtool::report {
namespace {

TEST(Base64, HasTheValuesOfRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, TakesEveryByte) { EXPECT_EQ(base64(std::string("\xff\xfe\x00\x80", 4)), "//4AgA=="); }

TEST(PngUri, HoldsTheBytes) { EXPECT_EQ(png_uri("foo"), "data:image/png;base64,Zm9v"); }

}  // namespace
}  // namespace ddtool::report
