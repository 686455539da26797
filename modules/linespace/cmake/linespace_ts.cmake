# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# OpenCV's test harness (modules/ts), which no distribution installs, built from the sources of the
# installed OpenCV and linked with the installed libraries.

find_package(Threads REQUIRED)
find_package(OpenCV ${OpenCV_VERSION} EXACT REQUIRED
             COMPONENTS core imgproc imgcodecs videoio highgui)

set(ts_dir "${OPENCV_SOURCE_DIR}/modules/ts")
set(version_file "${OPENCV_SOURCE_DIR}/modules/core/include/opencv2/core/version.hpp")
if(NOT EXISTS "${ts_dir}/src" OR NOT EXISTS "${version_file}")
  message(FATAL_ERROR "The tests need the sources of OpenCV ${OpenCV_VERSION}: "
    "run test/fetch_opencv_source.sh, or give -DOPENCV_SOURCE_DIR=..., or build without the tests: "
    "-DBUILD_TESTS=OFF -DBUILD_PERF_TESTS=OFF")
endif()
set(ts_version "")
foreach(part MAJOR MINOR REVISION)
  file(STRINGS "${version_file}" line REGEX "^#define CV_VERSION_${part} ")
  string(REGEX MATCH "[0-9]+$" number "${line}")
  list(APPEND ts_version ${number})
endforeach()
list(JOIN ts_version "." ts_version)
if(NOT ts_version VERSION_EQUAL OpenCV_VERSION)
  message(FATAL_ERROR "OPENCV_SOURCE_DIR has OpenCV ${ts_version}, installed is ${OpenCV_VERSION}")
endif()

# OpenCV's build writes its install prefix into this one; without it the environment tells where
# data is.
file(WRITE "${linespace_config_dir}/opencv_tests_config.hpp" "")

file(GLOB ts_sources "${ts_dir}/src/*.cpp")
list(FILTER ts_sources EXCLUDE REGEX "/cuda_[a-z]+\\.cpp$")
add_library(opencv_ts STATIC ${ts_sources})
target_compile_definitions(opencv_ts PRIVATE __OPENCV_BUILD=1 PUBLIC __OPENCV_TESTS=1)
target_include_directories(opencv_ts SYSTEM
  PRIVATE "${ts_dir}/src" PUBLIC "${ts_dir}/include" "${linespace_config_dir}")
# The harness uses private headers of core; the installed headers go first.
target_compile_options(opencv_ts PRIVATE
  "SHELL:-idirafter \"${OPENCV_SOURCE_DIR}/modules/core/include\"")
if(LINESPACE_SANITIZE)
  target_compile_options(opencv_ts PRIVATE -fno-sanitize=all) # they are for our code
endif()
target_link_libraries(opencv_ts PUBLIC opencv_core opencv_imgproc opencv_imgcodecs opencv_videoio
                                       opencv_highgui Threads::Threads)

# linespace_add_harness_program(NAME FOLDER): one program of all files of a folder of the module.
function(linespace_add_harness_program name folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.hpp)
  add_executable(${name} ${sources})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/${folder}")
  target_compile_options(${name} PRIVATE ${linespace_warnings} -Wno-shadow) # ts and OpenCV share many names
  target_link_libraries(${name} PRIVATE opencv_ts opencv_linespace)
endfunction()
