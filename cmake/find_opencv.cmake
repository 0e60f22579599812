# Finds the libraries opencv_core and opencv_imgproc, and sets OpenCV_INCLUDE_DIRS. find_package(OpenCV) is not used:
# Debian's OpenCVConfig.cmake is in libopencv-dev, which depends on all of OpenCV, VTK, GDAL and FFmpeg. imgcodecs is
# not used either, because Debian's loads GDAL and so takes 50 MB of memory; system/png_file.hpp writes the PNG files.
find_path(OpenCV_INCLUDE_DIRS opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
foreach(part core imgproc)
  find_library(OpenCV_${part} opencv_${part} REQUIRED)
  add_library(opencv_${part} SHARED IMPORTED)
  set_target_properties(opencv_${part} PROPERTIES IMPORTED_LOCATION ${OpenCV_${part}}
    INTERFACE_INCLUDE_DIRECTORIES ${OpenCV_INCLUDE_DIRS})
endforeach()
target_link_libraries(opencv_imgproc INTERFACE opencv_core)
