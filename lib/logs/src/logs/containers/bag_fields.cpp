#include "logs/containers/bag_fields.hpp"

#include "ddtool/base/error.hpp"
#include "logs/containers/mcap_fields.hpp"

namespace ddtool {

BagFields::BagFields(std::span<const std::byte> bytes) {
    McapFieldReader fields(bytes);
    while (!fields.rest().empty()) {
        std::string field = fields.take_string();
        const std::size_t separator = field.find('=');
        if (separator == std::string::npos) {
            throw Error("a header field without '='");
        }
        values_[field.substr(0, separator)] = field.substr(separator + 1);
    }
}

const std::string& BagFields::text(const std::string& name) const {
    const auto field = values_.find(name);
    if (field == values_.end()) {
        throw Error("the header field '" + name + "' is missing");
    }
    return field->second;
}

const std::string& BagFields::sized(const std::string& name, std::size_t size) const {
    const std::string& value = text(name);
    if (value.size() != size) {
        throw Error("the header field '" + name + "' has " + std::to_string(value.size()) + " bytes where " +
                    std::to_string(size) + " were expected");
    }
    return value;
}

std::int64_t BagFields::time_ns(const std::string& name) const {
    const auto time = number<std::uint64_t>(name);
    const auto seconds = static_cast<std::uint32_t>(time);
    const auto nanoseconds = static_cast<std::uint32_t>(time >> 32U);
    return std::int64_t{1'000'000'000} * seconds + nanoseconds;
}

}  // namespace ddtool
