#include "network/encoder_layer.hpp"

namespace ddtool::network {
namespace {

AffineLayer linear_of(NamedWeights& weights, const std::string& name, const LinearRow& row, std::size_t tokens) {
    return linear(weights, "encoder." + name, row, packed_tokens(tokens, row.inputs));
}

std::size_t size(std::int64_t value) { return static_cast<std::size_t>(value); }

}  // namespace

EncoderLayer::EncoderLayer(NamedWeights& weights, const EncoderRow& row, std::size_t tokens)
    : attention_norm_(weights, "encoder.attention_norm", tokens, size(row.width)),
      query_key_value_(linear_of(weights, "query_key_value", {size(row.width), 3 * size(row.width)}, tokens)),
      attention_(tokens, size(row.width), size(row.heads)),
      attention_out_(linear_of(weights, "attention_out", {size(row.width), size(row.width)}, tokens)),
      feed_forward_norm_(weights, "encoder.feed_forward_norm", tokens, size(row.width)),
      feed_forward_in_(
          linear_of(weights, "feed_forward_in", {size(row.width), size(row.feed_forward), /*relu=*/true}, tokens)),
      feed_forward_out_(linear_of(weights, "feed_forward_out", {size(row.feed_forward), size(row.width)}, tokens)) {}

const float* EncoderLayer::run(const float* in) {
    const float* const mixed = attention_.run(query_key_value_.run(attention_norm_.run(in)));
    const float* const attended = attention_out_.run(mixed, in);
    return feed_forward_out_.run(feed_forward_in_.run(feed_forward_norm_.run(attended)), attended);
}

}  // namespace ddtool::network
