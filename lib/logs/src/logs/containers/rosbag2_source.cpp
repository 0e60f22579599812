#include "logs/containers/rosbag2_source.hpp"

#include <utility>

#include "ddtool/base/error.hpp"

namespace ddtool {

Rosbag2Source::Rosbag2Source(std::vector<LogFile> files, OpenFile open, LogProblemHandler on_problem)
    : on_problem_(std::move(on_problem)), open_(std::move(open)), files_(std::move(files)) {
    const std::string failure = advance();
    if (!current_) {
        throw Error(failure);
    }
}

std::optional<McapMessage> Rosbag2Source::next() {
    while (current_) {
        if (const auto message = current_->next()) {
            return message;
        }
        advance();
    }
    return std::nullopt;
}

std::string Rosbag2Source::advance() {
    std::string first_failure;
    current_.reset();
    while (!current_ && opened_ < files_.size()) {
        try {
            current_ = open_(files_[opened_]);
        } catch (const Error& error) {
            const std::string failure = error.what();
            on_problem_({failure + "; the folder's other files are read"});
            first_failure = first_failure.empty() ? failure : first_failure;
        }
        ++opened_;
    }
    return first_failure;
}

double Rosbag2Source::fraction_read() const {
    const double before = static_cast<double>(opened_) - (current_ ? 1.0 : 0.0);
    return (before + (current_ ? current_->fraction_read() : 0.0)) / static_cast<double>(files_.size());
}

}  // namespace ddtool
