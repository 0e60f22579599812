#include "network/image_file.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "ddtool/network/particle_renderer.hpp"
#include "swarms.hpp"
#include "system/png_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using test::thrown_text;
using testing::AllOf;
using testing::HasSubstr;

class ImageFile : public testing::Test {
protected:
    ImageFile() {
        ParticleRenderer({}).render(test::normal_swarm(30, 1, {1.0, 0.2}), image_);
        write_image_file(path_, image_);
    }

    test::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "swarm.png";
    ParticleImage image_;
};

TEST_F(ImageFile, GivesTheSamePixelsBack) { EXPECT_EQ(read_image_file(path_, 224), image_); }

TEST_F(ImageFile, OfAnotherSizeIsRefusedByName) {
    EXPECT_THAT(thrown_text([&] { read_image_file(path_, 64); }), AllOf(HasSubstr("swarm.png"), HasSubstr("64 x 64")));
}

TEST_F(ImageFile, InColourIsRefused) {
    const std::vector<std::uint8_t> bgr(std::size_t{3} * 4 * 4, 7);
    write_png(path_, {.width_px = 4, .height_px = 4, .channels = 3, .pixels = bgr});
    EXPECT_THAT(thrown_text([&] { read_image_file(path_, 4); }), HasSubstr("not 8-bit grey"));
}

TEST_F(ImageFile, CutOffAnywhereIsRefusedByName) {
    for (auto size = std::filesystem::file_size(path_); size > 0; size /= 2) {
        std::filesystem::resize_file(path_, size / 2);
        EXPECT_THAT(thrown_text([&] { read_image_file(path_, 224); }), HasSubstr("swarm.png")) << size / 2 << " bytes";
    }
}

TEST_F(ImageFile, ThatIsMissingIsNamed) {
    EXPECT_THAT(thrown_text([&] { read_image_file(folder_ / "none.png", 224); }), HasSubstr("none.png"));
}

}  // namespace
}  // namespace ddtool
