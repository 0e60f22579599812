#pragma once

#include <vector>

#include "network/floats.hpp"
#include "network/product.hpp"

namespace ddtool::network {

/// Scaled dot-product attention of tokens to one another (Vaswani et al. 2017, equation 1), for each head separately.
class Attention {
public:
    /// The width of a head (width / heads) must be a multiple of block_width.
    Attention(std::size_t tokens, std::size_t width, std::size_t heads);

    /// query_key_value: [tokens][3][heads][width / heads]. The result [tokens][width] is the layer's own buffer, which
    /// is valid until the next run.
    const float* run(const float* query_key_value);

private:
    void transpose_keys(const float* keys);
    void score(const float* queries);
    void mix(const float* values, float* out);

    std::size_t tokens_;
    std::size_t width_;
    std::size_t head_width_;
    std::size_t row_step_;              // of scores: the tokens, rounded up to whole blocks
    std::vector<std::size_t> sources_;  // where each token lies in query_key_value, in scores_, in out_
    std::vector<std::size_t> score_rows_;
    std::vector<std::size_t> targets_;
    Floats keys_;    // [head_width][row_step]
    Floats scores_;  // [tokens][row_step], of one head at a time
    Floats out_;
};

}  // namespace ddtool::network
