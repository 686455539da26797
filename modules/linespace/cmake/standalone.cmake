# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# The module as a library of its own: what ocv_define_module does inside OpenCV's tree.

include(linespace_dispatch)

# OpenCV's own warnings, so that a clean build here is a clean build there.
set(linespace_warnings "$<$<CXX_COMPILER_ID:GNU,Clang>:-Wall;-Wextra;-Wundef;-Wshadow;\
-Wpointer-arith;-Wmissing-declarations;-Wnon-virtual-dtor;-Wsign-promo;-Wformat-security>")

# OpenCV generates these headers for itself and does not install them. They tell its headers and its
# test harness which instruction sets and devices this build uses.
set(linespace_config_dir "${CMAKE_CURRENT_BINARY_DIR}/config")
set(HAVE_OPENCL ${WITH_OPENCL})
configure_file(cmake/cvconfig.h.in "${linespace_config_dir}/cvconfig.h")
configure_file(cmake/cv_cpu_config.h.in "${linespace_config_dir}/cv_cpu_config.h")

file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp src/*.hpp include/opencv2/*.hpp)
add_library(opencv_linespace ${sources})
linespace_add_dispatched_file(opencv_linespace bundles AVX2 AVX512_SKX)
linespace_add_dispatched_file(opencv_linespace cascade AVX2 AVX512_SKX)
linespace_add_dispatched_file(opencv_linespace chord_lanes AVX2 AVX512_SKX)
linespace_add_dispatched_file(opencv_linespace exact/band_count AVX2 AVX512_SKX)
linespace_add_dispatched_file(opencv_linespace strips/strip_kernels AVX2 AVX512_SKX)

if(WITH_OPENCL)
  include(linespace_opencl)
endif()

# __OPENCV_BUILD switches OpenCV's headers to its instruction sets and CPU dispatch, as in its tree.
target_compile_definitions(opencv_linespace PRIVATE CVAPI_EXPORTS __OPENCV_BUILD=1)
target_compile_options(opencv_linespace PRIVATE ${linespace_warnings})
target_include_directories(opencv_linespace
  PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>"
         "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>"
  PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src" "${linespace_config_dir}")
target_link_libraries(opencv_linespace PUBLIC opencv_core PRIVATE opencv_imgproc ${CMAKE_DL_LIBS})
set_target_properties(opencv_linespace PROPERTIES
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  INSTALL_RPATH "")
if(UNIX AND NOT APPLE AND NOT LINESPACE_SANITIZE)
  target_link_options(opencv_linespace PRIVATE -Wl,--no-undefined)
endif()

include(linespace_install)

if(BUILD_TESTS OR BUILD_PERF_TESTS)
  include(linespace_ts)
endif()
if(BUILD_TESTS)
  linespace_add_harness_program(opencv_test_linespace test)
endif()
if(BUILD_PERF_TESTS)
  linespace_add_harness_program(opencv_perf_linespace perf)
endif()
