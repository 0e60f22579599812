#include "network/safetensors.hpp"

#include <bit>
#include <cstring>
#include <ostream>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::network {
namespace {

static_assert(std::endian::native == std::endian::little, "safetensors are little-endian");

constexpr const char* metadata_key = "__metadata__";
constexpr std::size_t length_bytes = sizeof(std::uint64_t);

std::string header_of(const PlainWeights& weights) {
    Json header;
    header[metadata_key] = {{"ddtool", weights.about}};
    std::size_t place = 0;
    for (const NamedTensor& tensor : weights.tensors) {
        const std::size_t end = place + tensor.values.size() * sizeof(float);
        header[tensor.name] = {{"dtype", "F32"}, {"shape", tensor.shape}, {"data_offsets", {place, end}}};
        place = end;
    }
    std::string text = header.dump();
    text.append((length_bytes - text.size() % length_bytes) % length_bytes, ' ');
    return text;
}

/// The number of values of a tensor of this shape. Throws Error if a length is negative or the number exceeds `most`.
std::size_t count_of(const std::vector<std::int64_t>& shape, std::size_t most) {
    std::size_t count = 1;
    for (const std::int64_t length : shape) {
        if (length < 0 || (length > 0 && count > most / static_cast<std::size_t>(length))) {
            throw Error("a shape that does not fit into the file");
        }
        count *= static_cast<std::size_t>(length);
    }
    return count;
}

NamedTensor tensor_at(const std::string& name, const Json& entry, std::string_view data) {
    const auto begin = entry.at("data_offsets").at(0).get<std::size_t>();
    const auto end = entry.at("data_offsets").at(1).get<std::size_t>();
    NamedTensor tensor{name, entry.at("shape").get<std::vector<std::int64_t>>(), {}};
    const std::size_t count = count_of(tensor.shape, data.size());
    if (entry.at("dtype") != "F32" || begin > end || end > data.size() || end - begin != count * sizeof(float)) {
        throw Error("tensor " + name + ": expected F32 values of its shape inside the file");
    }
    tensor.values.resize(count);
    std::memcpy(tensor.values.data(), data.data() + begin, end - begin);
    return tensor;
}

PlainWeights parsed(std::string_view bytes) {
    std::uint64_t length = 0;
    if (bytes.size() < length_bytes) {
        throw Error("shorter than its header");
    }
    std::memcpy(&length, bytes.data(), length_bytes);
    if (length > bytes.size() - length_bytes) {
        throw Error("a header of " + std::to_string(length) + " bytes in a file of " + std::to_string(bytes.size()));
    }
    const Json header = parse_json(bytes.substr(length_bytes, length), "header");
    const std::string_view data = bytes.substr(length_bytes + length);
    PlainWeights weights;
    for (const auto& [name, entry] : header.items()) {
        if (name == metadata_key) {
            weights.about = entry.value("ddtool", "");
        } else {
            weights.tensors.push_back(tensor_at(name, entry, data));
        }
    }
    return weights;
}

}  // namespace

void write_safetensors(const std::filesystem::path& path, const PlainWeights& weights) {
    write_file(path, [&](std::ostream& out) {
        const std::string header = header_of(weights);
        const std::uint64_t length = header.size();
        out.write(reinterpret_cast<const char*>(&length), length_bytes);
        out << header;
        for (const NamedTensor& tensor : weights.tensors) {
            out.write(reinterpret_cast<const char*>(tensor.values.data()),
                      static_cast<std::streamsize>(tensor.values.size() * sizeof(float)));
        }
    });
}

PlainWeights read_safetensors(const std::filesystem::path& path) {
    return parse_safetensors(read_file(path), path.string());
}

PlainWeights parse_safetensors(std::string_view bytes, const std::string& name) {
    try {
        return parsed(bytes);
    } catch (const Json::exception& error) {
        throw Error(name + ": damaged header: " + error.what());
    } catch (const Error& error) {
        throw Error(name + ": not plain weights (safetensors): " + error.what());
    }
}

}  // namespace ddtool::network
