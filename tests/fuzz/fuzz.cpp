#include <cstdint>

#include "readers.hpp"
#include "system/log.hpp"

/// The entry point of libFuzzer. The build target defines which reader it calls.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ddtool::set_log_level(ddtool::LogLevel::error);
    ddtool::fuzz::readers().at(DDTOOL_FUZZ_READER)({reinterpret_cast<const char*>(data), size});
    return 0;
}
