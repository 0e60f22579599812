#include "network/softmax.hpp"

#include "near.hpp"

namespace ddtool::network {
namespace {

TEST(ApplySoftmax, IsThatOfItsDefinitionFromTinyToHugeScores) {
    constexpr std::size_t columns = 21;
    constexpr std::size_t row_step = 32;
    for (const float size : {1e-3F, 1.0F, 10.0F, 1000.0F}) {
        std::vector<float> scores = drawn_floats(3 * row_step, 9);
        std::vector<naive::Values> expected;
        for (std::size_t row = 0; row < 3; ++row) {
            naive::Values scaled;
            for (std::size_t column = 0; column < columns; ++column) {
                scores[row * row_step + column] *= size;
                scaled.push_back(0.25 * scores[row * row_step + column]);
            }
            expected.push_back(naive::softmax(scaled));
        }
        apply_softmax({scores.data(), 3, columns, row_step}, 0.25F);
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < columns; ++column) {
                const double share = expected[row][column];
                EXPECT_NEAR(scores[row * row_step + column], share, 1e-6 * share + 1e-30) << size << " " << column;
            }
        }
    }
}

}  // namespace
}  // namespace ddtool::network
