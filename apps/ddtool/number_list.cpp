#include "number_list.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "base/text.hpp"
#include "ddtool/base/error.hpp"

namespace ddtool {

std::vector<double> number_list(const std::string& option, const std::string& text, const std::string& form,
                                std::size_t count) {
    std::vector<double> numbers;
    std::string_view rest = text;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        const std::optional<double> number = parse_number(word);
        if (!number) {
            numbers.clear();
            break;
        }
        numbers.push_back(*number);
    }
    if (numbers.size() != count) {
        throw UsageError(option + ": expected " + form + ", not '" + text + "'");
    }
    return numbers;
}

Pose2 pose_option(const std::string& option, const std::string& text) {
    const std::vector<double> numbers = number_list(option, text, "x,y,yaw in metres and radians", 3);
    if (std::abs(numbers[2]) > 2.0 * std::numbers::pi) {
        throw UsageError(option + ": expected a yaw in radians, at most a full turn (6.28), not " +
                         fixed_text(numbers[2], 2) + "; is it in degrees?");
    }
    return {numbers[0], numbers[1], wrap_angle(numbers[2])};
}

}  // namespace ddtool
