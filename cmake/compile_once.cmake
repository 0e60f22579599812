# Most of the time in which a source of a few lines is compiled goes into headers of others. Two things save it.
#
# Precompiled headers: what is listed here is compiled once and stands before every source. Sources include what they use
# all the same; scripts/check-style tidy reads them without.
#
# Unity builds (DDTOOL_UNITY): the sources of a target are compiled a dozen at a time, each dozen as if it were one file.
# Hence names in the unnamed namespaces of one target must differ, also those of functions whose parameters do.

# ddtool_precompiled_headers(NAME OPTIONS option... HEADERS header... USES target...): precompiled headers that all
# targets compiled with these options may share.
function(ddtool_precompiled_headers NAME)
  cmake_parse_arguments(SET "" "" "OPTIONS;HEADERS;USES" ${ARGN})
  set(nothing ${CMAKE_CURRENT_BINARY_DIR}/${NAME}.cpp)
  file(CONFIGURE OUTPUT ${nothing} CONTENT "")
  add_library(${NAME} OBJECT ${nothing})
  target_compile_options(${NAME} PRIVATE ${SET_OPTIONS})
  target_link_libraries(${NAME} PRIVATE ddtool_options Eigen3::Eigen nlohmann_json::nlohmann_json ${SET_USES})
  target_precompile_headers(${NAME} PRIVATE
    <algorithm> <array> <chrono> <cmath> <deque> <filesystem> <fstream> <functional> <iostream> <map> <memory> <numeric>
    <optional> <set> <span> <sstream> <string> <string_view> <thread> <utility> <variant> <vector>
    <Eigen/Dense> <nlohmann/json.hpp> ${SET_HEADERS})
endfunction()

# ddtool_compile_once(TARGET [HEADERS]): with the precompiled headers of that name, or without any.
function(ddtool_compile_once TARGET)
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ${DDTOOL_UNITY} UNITY_BUILD_BATCH_SIZE 12)
  if(ARGN)
    target_precompile_headers(${TARGET} REUSE_FROM ${ARGN})
  endif()
endfunction()

ddtool_precompiled_headers(ddtool_headers)
