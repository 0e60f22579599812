#include "network/stem.hpp"

#include "dd_weights.hpp"
#include "near.hpp"

namespace ddtool::network {
namespace {

constexpr std::size_t stem_size_px = 30;

/// An image whose pixels are marked with that probability. Unless it is 0, all four corners are marked, too.
std::vector<float> drawn_image(double share) {
    RandomStream random({7});
    std::vector<float> image(stem_size_px * stem_size_px);
    for (float& pixel : image) {
        pixel = random.uniform() < share ? 1.0F : 0.0F;
    }
    for (const std::size_t corner :
         {std::size_t{0}, stem_size_px - 1, stem_size_px * (stem_size_px - 1), stem_size_px * stem_size_px - 1}) {
        image[corner] = share > 0.0 ? 1.0F : 0.0F;
    }
    return image;
}

class StemOf : public testing::TestWithParam<network::StemRow> {
protected:
    StemOf() { drawn_.add_convolution("stem", GetParam().channels, 1, GetParam().kernel_px); }

    [[nodiscard]] naive::Map expected(const std::vector<float>& image) const {
        const naive::Map in{1, stem_size_px, doubles(image)};
        return naive::relu(naive::max_pool(naive::convolution(
            drawn_.tensors, "stem", in, static_cast<std::size_t>(GetParam().channels),
            static_cast<std::size_t>(GetParam().kernel_px), static_cast<std::size_t>(GetParam().stride))));
    }

    test::DrawnWeights drawn_{8};
};

TEST_P(StemOf, IsThatOfItsDefinitionHoweverManyPixelsAreMarked) {
    NamedWeights weights(drawn_.tensors);
    Stem stem(weights, GetParam(), stem_size_px);
    for (const double share : {0.0, 0.02, 0.5, 1.0, 0.02}) {
        const std::vector<float> image = drawn_image(share);
        expect_near(planar(stem.run(image), stem.out_shape()).data(), expected(image).values, 5e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, StemOf,
                         testing::Values(network::StemRow{.kernel_px = 7, .stride = 4, .channels = 16},
                                         network::StemRow{.kernel_px = 7, .stride = 2, .channels = 32},
                                         network::StemRow{.kernel_px = 3, .stride = 1, .channels = 16}));

}  // namespace
}  // namespace ddtool::network
