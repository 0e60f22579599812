#include "network/attention.hpp"

#include <cmath>

#include "network/affine_layer.hpp"
#include "network/softmax.hpp"

namespace ddtool::network {

Attention::Attention(std::size_t tokens, std::size_t width, std::size_t heads)
    : tokens_(tokens),
      width_(width),
      head_width_(width / heads),
      row_step_((tokens + block_width - 1) / block_width * block_width),
      sources_(packed_tokens(tokens, 3 * width)),
      score_rows_(packed_tokens(tokens, row_step_)),
      targets_(packed_tokens(tokens, width)),
      keys_(head_width_ * row_step_, 0.0F),
      scores_(tokens * row_step_),
      out_(tokens * width) {}

const float* Attention::run(const float* query_key_value) {
    const float scale = 1.0F / std::sqrt(static_cast<float>(head_width_));
    for (std::size_t head = 0; head < width_; head += head_width_) {
        transpose_keys(query_key_value + width_ + head);
        score(query_key_value + head);
        apply_softmax({scores_.data(), tokens_, tokens_, row_step_}, scale);
        mix(query_key_value + 2 * width_ + head, out_.data() + head);
    }
    return out_.data();
}

void Attention::transpose_keys(const float* keys) {
    for (std::size_t token = 0; token < tokens_; ++token) {
        for (std::size_t i = 0; i < head_width_; ++i) {
            keys_[i * row_step_ + token] = keys[sources_[token] + i];
        }
    }
}

void Attention::score(const float* queries) {
    multiply({.in = queries,
              .from = sources_,
              .window = {.length = head_width_},
              .weights = {.first = keys_.data(), .input_step = row_step_, .block_step = block_width},
              .outputs = row_step_,
              .out = scores_.data(),
              .to = score_rows_});
}

void Attention::mix(const float* values, float* out) {
    multiply({.in = scores_.data(),
              .from = score_rows_,
              .window = {.length = tokens_},
              .weights = {.first = values, .input_step = 3 * width_, .block_step = block_width},
              .outputs = head_width_,
              .out = out,
              .to = targets_});
}

}  // namespace ddtool::network
