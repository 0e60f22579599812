#pragma once

#include "ddtool/base/error.hpp"

namespace ddtool {

/// Descriptors 0 to 2 that were closed by whoever started the program are opened so that using them fails: otherwise a
/// file of ours would get the number, and what is printed would end up in it.
void reserve_standard_descriptors();

/// A file that is cut short while it is mapped into memory raises SIGBUS: from now on that is one line and
/// ExitCode::failed.
void explain_bus_errors();

/// Writes out what was printed. Throws Error when standard output did not take all of it.
void flush_results();

/// Throws Error when a limit of memory leaves too little for LibTorch: short of it, OpenBLAS asks for more without end
/// and oneDNN crashes, neither of which could be told from here.
void expect_memory_for_libtorch();

/// The value for main to return. Under a limit of memory the program ends here, without its libraries' farewell, in
/// which OpenBLAS would wait for threads that try without end to get memory.
int exit_status(ExitCode code);

}  // namespace ddtool
