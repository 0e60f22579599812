# A source of a few lines spends most of its compile time in the headers that it includes. Two techniques save it.
#
# Precompiled headers: the headers listed here are compiled once and included before every source. Sources still include
# all that they use; scripts/check-style tidy checks this by compiling them without precompiled headers.
#
# Unity builds (DDTOOL_UNITY): twelve sources of a target at a time are compiled as if they were one file. Therefore the
# names in the unnamed namespaces of one target must all differ; even functions with different parameters must not share
# one.

# ddtool_precompiled_headers(NAME OPTIONS option... HEADERS header... USES target...): makes precompiled headers that
# all targets compiled with these options can share.
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

# ddtool_compile_once(TARGET [HEADERS]): compiles the target in unity builds, with the precompiled headers of that name
# if one is given.
function(ddtool_compile_once TARGET)
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ${DDTOOL_UNITY} UNITY_BUILD_BATCH_SIZE 12)
  if(ARGN)
    target_precompile_headers(${TARGET} REUSE_FROM ${ARGN})
  endif()
endfunction()

ddtool_precompiled_headers(ddtool_headers)
