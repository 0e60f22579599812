#pragma once

namespace ddtool {

/// Combines several function objects into one, for std::visit: overloaded{[](const A&) {...}, [](const B&) {...}}.
template <typename... Functions>
struct overloaded : Functions... {
    using Functions::operator()...;
};
template <typename... Functions>
overloaded(Functions...) -> overloaded<Functions...>;

}  // namespace ddtool
