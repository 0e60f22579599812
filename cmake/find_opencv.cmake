# Finds the libraries opencv_core and opencv_imgproc, and sets OpenCV_INCLUDE_DIRS. find_package(OpenCV) is not used:
# Debian's OpenCVConfig.cmake is in libopencv-dev, which depends on all of OpenCV, VTK, GDAL and FFmpeg. imgcodecs is
# not used either, because Debian's loads GDAL and so takes 50 MB of memory; system/png_file.hpp writes the PNG files.
option(DDTOOL_STATIC_OPENCV "Put OpenCV into the programs: Debian's shared one needs OpenGL, 200 MB of drivers" OFF)
find_path(OpenCV_INCLUDE_DIRS opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
set(opencv_kind SHARED)
set(opencv_suffix "")
if(DDTOOL_STATIC_OPENCV)
  set(opencv_kind STATIC)
  set(opencv_suffix .a)
endif()
foreach(part core imgproc)
  find_library(OpenCV_${part}_${opencv_kind} NAMES libopencv_${part}${opencv_suffix} opencv_${part} REQUIRED)
  add_library(opencv_${part} ${opencv_kind} IMPORTED)
  set_target_properties(opencv_${part} PROPERTIES IMPORTED_LOCATION ${OpenCV_${part}_${opencv_kind}}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_INCLUDE_DIRS})
endforeach()
target_link_libraries(opencv_imgproc INTERFACE opencv_core)
if(DDTOOL_STATIC_OPENCV)
  # What the archive needs. The development files of LAPACK and BLAS are not there, but the libraries are.
  find_library(OpenCV_lapack liblapack.so.3 REQUIRED)
  find_library(OpenCV_blas libblas.so.3 REQUIRED)
  find_library(OpenCV_tbb tbb REQUIRED)
  find_package(ZLIB REQUIRED)
  add_library(ddtool_no_opengl STATIC ${PROJECT_SOURCE_DIR}/cmake/no_opengl.cpp)
  target_link_libraries(opencv_core INTERFACE
    ddtool_no_opengl ${OpenCV_tbb} ${OpenCV_lapack} ${OpenCV_blas} ZLIB::ZLIB Threads::Threads ${CMAKE_DL_LIBS})
endif()
