#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ddtool::network {

/// A tensor of float32 values in memory, in C order.
struct NamedTensor {
    std::string name;
    std::vector<std::int64_t> shape;
    std::vector<float> values;
};

/// Plain weights in the safetensors format (github.com/huggingface/safetensors): eight bytes with the length of the
/// header, a JSON header with type, shape and place of every tensor, then the values. Many programs can open it, and
/// unlike TorchScript it contains no program. `about` is stored under __metadata__ as "ddtool". No Debian package reads
/// or writes the format from C++.
struct PlainWeights {
    std::string about;
    std::vector<NamedTensor> tensors;
};

/// Throws Error naming the file if it cannot be written.
void write_safetensors(const std::filesystem::path& path, const PlainWeights& weights);
/// Throws Error naming the file and the problem if it is damaged or holds other types than F32.
PlainWeights read_safetensors(const std::filesystem::path& path);
/// The same for a file's content; `name` is used in error messages.
PlainWeights parse_safetensors(std::string_view bytes, const std::string& name);

}  // namespace ddtool::network
