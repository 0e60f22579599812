#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ddtool::native {

/// A tensor of float32 in memory, C order.
struct NamedTensor {
    std::string name;
    std::vector<std::int64_t> shape;
    std::vector<float> values;
};

/// Plain weights in the safetensors format (github.com/huggingface/safetensors: eight bytes of header length, a JSON
/// header with type, shape and place of every tensor, the values): what opens anywhere, without a program inside as
/// TorchScript has. `about` is kept under __metadata__ as "ddtool". No Debian package reads or writes it from C++.
struct PlainWeights {
    std::string about;
    std::vector<NamedTensor> tensors;
};

void write_safetensors(const std::filesystem::path& path, const PlainWeights& weights);
/// Throws Error naming the file and what is wrong for one that is damaged or holds other types than F32.
PlainWeights read_safetensors(const std::filesystem::path& path);
/// The same for a file's content; `name` is for errors.
PlainWeights parse_safetensors(std::string_view bytes, const std::string& name);

}  // namespace ddtool::native
