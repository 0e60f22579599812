#pragma once

#include <string>

#include "ddtool/base/error.hpp"

namespace ddtool::test {

/// The text of the error of type ErrorType that `action` throws, or an empty text if it throws none.
template <typename ErrorType = Error, typename Action>
std::string thrown_text(Action&& action) {
    try {
        action();
    } catch (const ErrorType& error) {
        return error.what();
    }
    return "";
}

}  // namespace ddtool::test
