# The libraries opencv_core and opencv_imgproc, and OpenCV_INCLUDE_DIRS. Not by find_package: Debian's OpenCVConfig.cmake
# is in libopencv-dev, which needs all of OpenCV, VTK, GDAL and FFmpeg. Not imgcodecs: Debian's brings GDAL and 50 MB of
# memory with it; PNG files are written by system/png_file.hpp.
find_path(OpenCV_INCLUDE_DIRS opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
foreach(part core imgproc)
  find_library(OpenCV_${part} opencv_${part} REQUIRED)
  add_library(opencv_${part} SHARED IMPORTED)
  set_target_properties(opencv_${part} PROPERTIES IMPORTED_LOCATION ${OpenCV_${part}}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_INCLUDE_DIRS})
endforeach()
target_link_libraries(opencv_imgproc INTERFACE opencv_core)
