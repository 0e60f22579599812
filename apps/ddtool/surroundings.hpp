#pragma once

#include "ddtool/base/error.hpp"

namespace ddtool {

/// If the program was started with one of the descriptors 0 to 2 closed, opens it in such a way that using it fails.
/// Otherwise the next file that ddtool opens would get the number, and printed text would be written into that file.
void reserve_standard_descriptors();

/// From now on, SIGBUS ends the program with one line on stderr and ExitCode::failed. The system raises it if a file
/// that is mapped into memory is cut short.
void explain_bus_errors();

/// Flushes standard output. Throws Error if it could not be written completely.
void flush_results();

/// Throws Error if a limit on memory leaves too little for LibTorch. Without enough memory OpenBLAS would ask for more
/// without end and oneDNN would crash, and neither failure could be reported from here.
void expect_memory_for_libtorch();

/// Returns the value for main(). Under a limit on memory it does not return but ends the program at once, without
/// running the destructors of its libraries: OpenBLAS's would wait for threads that try without end to get memory.
int exit_status(ExitCode code);

}  // namespace ddtool
