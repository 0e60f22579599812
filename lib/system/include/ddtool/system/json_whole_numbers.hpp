#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <utility>

/// Reads a whole number only from a whole number that fits its type, and throws type_error for anything else. The
/// library itself would convert silently: 1.5 to 1, -1 to the largest count, and 1e30 to an arbitrary value, because
/// the conversion is undefined in C++.
template <typename Whole>
struct nlohmann::adl_serializer<Whole, std::enable_if_t<std::is_integral_v<Whole> && !std::is_same_v<Whole, bool>>> {
    template <typename AnyJson>
    static void to_json(AnyJson& json, Whole value) {
        nlohmann::to_json(json, value);
    }

    template <typename AnyJson>
    static void from_json(const AnyJson& json, Whole& value) {
        if (json.is_number_unsigned()) {
            take(json, *json.template get_ptr<const typename AnyJson::number_unsigned_t*>(), value);
        } else if (json.is_number_integer()) {
            take(json, *json.template get_ptr<const typename AnyJson::number_integer_t*>(), value);
        } else {
            fail(json);
        }
    }

private:
    template <typename AnyJson, typename Number>
    static void take(const AnyJson& json, Number number, Whole& value) {
        if (!std::in_range<Whole>(number)) {
            fail(json);
        }
        value = static_cast<Whole>(number);
    }

    template <typename AnyJson>
    [[noreturn]] static void fail(const AnyJson& json) {
        using Range = std::numeric_limits<Whole>;
        const std::string expected =
            "expected a whole number from " + std::to_string(Range::min()) + " to " + std::to_string(Range::max());
        throw AnyJson::type_error::create(302, expected + (json.is_number() ? ", not " + json.dump() : ""), &json);
    }
};
