# Writes build_commit.hpp with the commit of the checkout or of the source archive. It runs at every build, but changes the file only if the
# commit has changed, so that nothing is compiled again without need. Arguments: SOURCE_DIR, HEADER.
cmake_minimum_required(VERSION 3.25)

set(commit "unknown")
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/archived_commit.txt archived REGEX "^[0-9a-f]+$")  # in an archive alone
if(archived)
  string(SUBSTRING "${archived}" 0 12 commit)
endif()
set(git git --no-optional-locks -c safe.directory=* -C ${SOURCE_DIR})
execute_process(COMMAND ${git} rev-parse --show-toplevel
  OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
# If a source archive was unpacked inside another checkout, the commit of that checkout must not be used.
file(REAL_PATH "${SOURCE_DIR}" source_dir)
if(failed EQUAL 0 AND top STREQUAL source_dir)
  execute_process(COMMAND ${git} describe --always --dirty --exclude=* --abbrev=12
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0)
    set(commit "${described}")
  endif()
endif()
file(CONFIGURE OUTPUT "${HEADER}" CONTENT "#pragma once\n\n#define DDTOOL_COMMIT \"${commit}\"\n")
