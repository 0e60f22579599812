# Makes one Debian package for each component: ddtool, ddtool-torch (which needs LibTorch's 300 MB), ddtool-ros (which
# needs a DDS library), python3-ddtool, and libddtool-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ddtool)
set(CPACK_PACKAGE_CONTACT "ddtool developers <ddtool@users.noreply.github.com>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_COMPONENTS_ALL runtime development)
if(DDTOOL_WITH_TORCH)
  list(APPEND CPACK_COMPONENTS_ALL torch)
endif()
if(DDTOOL_WITH_DDS)
  list(APPEND CPACK_COMPONENTS_ALL ros)
endif()
if(DDTOOL_WITH_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME ddtool)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "ddtool-torch, ddtool-ros")

set(CPACK_DEBIAN_TORCH_PACKAGE_NAME ddtool-torch)
set(CPACK_DEBIAN_TORCH_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TORCH_PACKAGE_DEPENDS "ddtool (= ${PROJECT_VERSION})")

set(CPACK_DEBIAN_ROS_PACKAGE_NAME ddtool-ros)
set(CPACK_DEBIAN_ROS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_ROS_PACKAGE_DEPENDS "ddtool (= ${PROJECT_VERSION})")

# A compiled module works with the Python that it was built for alone.
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-ddtool)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
  "python3 (>= ${DDTOOL_PYTHON_VERSION}), python3 (<< ${DDTOOL_PYTHON_NEXT_VERSION}), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "ddtool, python3-torch")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/python/postinst
  ${CMAKE_CURRENT_SOURCE_DIR}/python/prerm)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libddtool-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(JOIN ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  cmake pkg-config libeigen3-dev nlohmann-json3-dev libspdlog-dev libfastcdr-dev libprotobuf-dev protobuf-compiler
  libpng-dev liblz4-dev libzstd-dev zlib1g-dev libmd-dev libbz2-dev libsqlite3-dev libyaml-cpp-dev)
include(CPack)
