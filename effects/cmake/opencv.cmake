# Finds OpenCV by hand: Debian's OpenCVConfig.cmake is in libopencv-dev, which depends on libopencv-highgui-dev and so
# on Qt. The modules below have no such dependency. They are those of the core, which reads videos and pictures
# without OpenCV: imgcodecs loads 120 more libraries, GDAL among them.
find_path(LAPFX_OPENCV_INCLUDE opencv2/core.hpp PATH_SUFFIXES opencv4 REQUIRED)
add_library(lapfx_opencv INTERFACE)
target_include_directories(lapfx_opencv SYSTEM INTERFACE ${LAPFX_OPENCV_INCLUDE})
foreach(module core imgproc)
    find_library(LAPFX_OPENCV_${module} opencv_${module} REQUIRED)
    target_link_libraries(lapfx_opencv INTERFACE ${LAPFX_OPENCV_${module}})
endforeach()
