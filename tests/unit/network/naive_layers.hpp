#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "network/dd_tables.hpp"
#include "network/safetensors.hpp"

/// The layers exactly as they are defined, in doubles. The layers of lib/network are compared with them.
namespace ddtool::network::naive {

using Values = std::vector<double>;
using Tensors = std::vector<network::NamedTensor>;

inline Values tensor(const Tensors& tensors, const std::string& name) {
    const auto found = std::find_if(tensors.begin(), tensors.end(), [&](const auto& t) { return t.name == name; });
    return {found->values.begin(), found->values.end()};
}

/// A map stored channel by channel, row by row.
struct Map {
    std::size_t channels = 0;
    std::size_t side = 0;
    Values values = Values(channels * side * side);

    [[nodiscard]] double& at(std::size_t channel, std::size_t y, std::size_t x) {
        return values[(channel * side + y) * side + x];
    }
    /// The value at that place, or `outside` beyond the edges.
    [[nodiscard]] double padded(std::size_t channel, std::ptrdiff_t y, std::ptrdiff_t x, double outside) const {
        const auto length = static_cast<std::ptrdiff_t>(side);
        return y < 0 || x < 0 || y >= length || x >= length
                   ? outside
                   : values[(channel * side + static_cast<std::size_t>(y)) * side + static_cast<std::size_t>(x)];
    }
};

/// Computes every output by value_of(channel, y, x), where y and x are the window's middle in the input.
template <typename ValueOf>
Map windows(const Map& in, std::size_t channels, std::size_t stride, const ValueOf& value_of) {
    Map out{channels, (in.side - 1) / stride + 1};
    for (std::size_t channel = 0; channel < channels; ++channel) {
        for (std::size_t y = 0; y < out.side; ++y) {
            for (std::size_t x = 0; x < out.side; ++x) {
                out.at(channel, y, x) =
                    value_of(channel, static_cast<std::ptrdiff_t>(y * stride), static_cast<std::ptrdiff_t>(x * stride));
            }
        }
    }
    return out;
}

/// Convolution followed by batch normalisation.
inline Map convolution(const Tensors& tensors, const std::string& prefix, const Map& in, std::size_t channels,
                       std::size_t kernel_px, std::size_t stride) {
    const Values kernel = tensor(tensors, prefix + ".conv.weight");
    const Values factor = tensor(tensors, prefix + ".norm.weight");
    const Values shift = tensor(tensors, prefix + ".norm.bias");
    const Values mean = tensor(tensors, prefix + ".norm.running_mean");
    const Values variance = tensor(tensors, prefix + ".norm.running_var");
    return windows(in, channels, stride, [&](std::size_t out, std::ptrdiff_t y, std::ptrdiff_t x) {
        double sum = 0.0;
        std::size_t index = out * in.channels * kernel_px * kernel_px;
        const auto size = static_cast<std::ptrdiff_t>(kernel_px);
        for (std::size_t channel = 0; channel < in.channels; ++channel) {
            for (std::ptrdiff_t ky = -size / 2; ky <= size / 2; ++ky) {
                for (std::ptrdiff_t kx = -size / 2; kx <= size / 2; ++kx) {
                    sum += kernel[index++] * in.padded(channel, y + ky, x + kx, 0.0);
                }
            }
        }
        return (sum - mean[out]) / std::sqrt(variance[out] + 1e-5) * factor[out] + shift[out];
    });
}

inline Map max_pool(const Map& in) {
    return windows(in, in.channels, 2, [&](std::size_t channel, std::ptrdiff_t y, std::ptrdiff_t x) {
        double most = -1e300;
        for (std::ptrdiff_t ky = -1; ky <= 1; ++ky) {
            for (std::ptrdiff_t kx = -1; kx <= 1; ++kx) {
                most = std::max(most, in.padded(channel, y + ky, x + kx, -1e300));
            }
        }
        return most;
    });
}

inline Values relu(Values values) {
    for (double& value : values) {
        value = std::max(value, 0.0);
    }
    return values;
}

inline Map relu(const Map& map) { return {map.channels, map.side, relu(map.values)}; }

inline Values sum(Values a, const Values& b) {
    for (std::size_t index = 0; index < a.size(); ++index) {
        a[index] += b[index];
    }
    return a;
}

/// A linear layer for tokens that are stored without gaps.
inline Values linear(const Tensors& tensors, const std::string& prefix, const Values& in, std::size_t inputs) {
    const Values weight = tensor(tensors, prefix + ".weight");
    const Values bias = tensor(tensors, prefix + ".bias");
    Values out;
    for (std::size_t token = 0; token < in.size() / inputs; ++token) {
        for (std::size_t output = 0; output < bias.size(); ++output) {
            double total = bias[output];
            for (std::size_t input = 0; input < inputs; ++input) {
                total += weight[output * inputs + input] * in[token * inputs + input];
            }
            out.push_back(total);
        }
    }
    return out;
}

inline Values layer_norm(const Tensors& tensors, const std::string& prefix, const Values& in) {
    const Values weight = tensor(tensors, prefix + ".weight");
    const Values bias = tensor(tensors, prefix + ".bias");
    const std::size_t width = weight.size();
    Values out;
    for (std::size_t first = 0; first < in.size(); first += width) {
        double mean = 0.0;
        double variance = 0.0;
        for (std::size_t i = 0; i < width; ++i) {
            mean += in[first + i] / static_cast<double>(width);
        }
        for (std::size_t i = 0; i < width; ++i) {
            variance += (in[first + i] - mean) * (in[first + i] - mean) / static_cast<double>(width);
        }
        for (std::size_t i = 0; i < width; ++i) {
            out.push_back((in[first + i] - mean) / std::sqrt(variance + 1e-5) * weight[i] + bias[i]);
        }
    }
    return out;
}

inline Values softmax(const Values& scores) {
    Values shares;
    double total = 0.0;
    for (const double score : scores) {
        shares.push_back(std::exp(score - *std::max_element(scores.begin(), scores.end())));
        total += shares.back();
    }
    for (double& share : shares) {
        share /= total;
    }
    return shares;
}

/// query_key_value has the shape [tokens][3][width].
inline Values attention(const Values& query_key_value, std::size_t width, std::size_t heads) {
    const std::size_t tokens = query_key_value.size() / (3 * width);
    const std::size_t head_width = width / heads;
    const auto at = [&](std::size_t token, std::size_t part, std::size_t i) {
        return query_key_value[(token * 3 + part) * width + i];
    };
    Values out(tokens * width);
    for (std::size_t head = 0; head < width; head += head_width) {
        for (std::size_t token = 0; token < tokens; ++token) {
            Values scores(tokens);
            for (std::size_t other = 0; other < tokens; ++other) {
                for (std::size_t i = head; i < head + head_width; ++i) {
                    scores[other] += at(token, 0, i) * at(other, 1, i) / std::sqrt(static_cast<double>(head_width));
                }
            }
            const Values shares = softmax(scores);
            for (std::size_t other = 0; other < tokens; ++other) {
                for (std::size_t i = head; i < head + head_width; ++i) {
                    out[token * width + i] += shares[other] * at(other, 2, i);
                }
            }
        }
    }
    return out;
}

}  // namespace ddtool::network::naive
