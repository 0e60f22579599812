#include "scores/tum_file.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::TemporaryFolder;
using test::thrown_text;
using testing::HasSubstr;

class TumFile : public testing::Test {
protected:
    Trajectory parsed(const std::string& content) {
        write_file(file_, content);
        return read_tum(file_);
    }

    TemporaryFolder folder_;
    std::filesystem::path file_ = folder_ / "a.tum";
};

TEST_F(TumFile, ThereAndBackKeepsStampsAndPoses) {
    const Trajectory written{{-1, {1.0, -2.0, 0.5}},
                             {-3'000'000'001, {0.0, 0.0, 3.1}},
                             {0, {}},
                             {1'700'000'000'123'456'789, {-123.456789, 1e-6, -3.1}}};
    write_tum(file_, written);
    const Trajectory read = read_tum(file_);
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t pose = 0; pose < read.size(); ++pose) {
        EXPECT_EQ(read[pose].stamp_ns, written[pose].stamp_ns);
        EXPECT_NEAR(read[pose].pose.x_m, written[pose].pose.x_m, 1e-6);
        EXPECT_NEAR(read[pose].pose.y_m, written[pose].pose.y_m, 1e-6);
        EXPECT_NEAR(read[pose].pose.theta_rad, written[pose].pose.theta_rad, 1e-8);
    }
}

TEST_F(TumFile, ReadsCommentsBlankLinesAndScientificNumbers) {
    const Trajectory read = parsed("# a comment\n\n 1.5e+00\t1 2 0 0 0 0 1\r\n2 3 4 0 0 0 0 1");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].stamp_ns, 1'500'000'000);
    EXPECT_EQ(read[1].pose, (Pose2{3.0, 4.0, 0.0}));
}

TEST_F(TumFile, YawDoesNotDependOnTheQuaternionsLength) {
    EXPECT_NEAR(parsed("0 0 0 0 0 0 3 3").front().pose.theta_rad, std::acos(0.0), 1e-12);
}

TEST_F(TumFile, BadLineIsNamed) {
    for (const std::string bad :
         {"1 2 3", "1 2 3 0 0 0 0 1 9", "x 0 0 0 0 0 0 1", "1 0 0 0 0 0 0 nan", "1 0 0 0 0 0 0 0"}) {
        EXPECT_THAT(thrown_text([&] { parsed("0 0 0 0 0 0 0 1\n# two\n" + bad + "\n"); }),
                    HasSubstr("a.tum:3: expected"))
            << bad;
    }
}

TEST_F(TumFile, MissingFileIsNamed) {
    EXPECT_THAT(thrown_text([&] { read_tum(folder_ / "none.tum"); }), HasSubstr("none.tum: cannot"));
    EXPECT_THAT(thrown_text([&] { read_tum(folder_ / "."); }), HasSubstr("cannot"));
}

}  // namespace
}  // namespace ddtool
