#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "logs/containers/mcap_reader.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The messages of an MCAP file as a MessageSource.
class McapMessageSource : public MessageSource {
public:
    McapMessageSource(const std::filesystem::path& path, LogProblemHandler on_problem)
        : reader_(path, std::move(on_problem)) {}
    McapMessageSource(ByteSource source, LogProblemHandler on_problem)
        : reader_(std::move(source), std::move(on_problem)) {}
    std::optional<McapMessage> next() override { return reader_.next(); }
    [[nodiscard]] double fraction_read() const override { return reader_.fraction_read(); }

private:
    McapReader reader_;
};

}  // namespace ddtool
