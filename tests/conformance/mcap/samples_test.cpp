#include <gmock/gmock.h>

#include <filesystem>
#include <string>
#include <vector>

#include "expected_messages.hpp"

namespace ddtool::test {
namespace {

const std::filesystem::path samples = DDTOOL_MCAP_SAMPLES;

class McapSample : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(
    OfMcapCore, McapSample,
    testing::ValuesIn(read_json(samples / "expected.json").at("samples").get<std::vector<std::string>>()),
    [](const auto& sample) { return std::filesystem::path(sample.param).stem().string(); });

TEST_P(McapSample, HoldsTheMessagesThatWentIn) {
    const ReadBack result = read_back_without_ids(samples / GetParam());
    EXPECT_FALSE(result.error);
    EXPECT_THAT(result.problems, testing::IsEmpty());
    EXPECT_EQ(result.messages, expected_messages(samples / "expected.json"));
}

}  // namespace
}  // namespace ddtool::test
