#include <cstdint>

#include "readers.hpp"
#include "system/log.hpp"

/// libFuzzer's entry; the target says which reader it is of.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ddtool::set_log_level(ddtool::LogLevel::error);
    ddtool::fuzz::readers().at(DDTOOL_FUZZ_READER)({reinterpret_cast<const char*>(data), size});
    return 0;
}
