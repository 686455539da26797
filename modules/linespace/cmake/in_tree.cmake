# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Builds OpenCV, reduced to what the module needs, with the module inside: proves that the module is
# one, and gives cv2 with cv2.linespace. Everything ends in opencv/ of the build folder.

if(NOT EXISTS "${OPENCV_SOURCE_DIR}/CMakeLists.txt")
  message(FATAL_ERROR "No OpenCV sources in OPENCV_SOURCE_DIR=${OPENCV_SOURCE_DIR}; "
                      "test/fetch_opencv_source.sh fetches them")
endif()

# The sources of Debian's package come without OpenCV's bundled libraries: what is not needed is
# switched off, whatever the version, the rest comes from the system.
file(STRINGS "${OPENCV_SOURCE_DIR}/CMakeLists.txt" options REGEX "^ *OCV_OPTION\\(WITH_[A-Z0-9_]+ ")
list(TRANSFORM options REPLACE "^ *OCV_OPTION\\((WITH_[A-Z0-9_]+) .*" "-D\\1=OFF")
list(REMOVE_ITEM options -DWITH_JPEG=OFF -DWITH_PNG=OFF -DWITH_PTHREADS_PF=OFF)
if(WITH_OPENCL)
  list(REMOVE_ITEM options -DWITH_OPENCL=OFF)
endif()

# Optimised little and for few instruction sets: it is for correctness, and waited for.
set(configure
  "${CMAKE_COMMAND}" -S "${OPENCV_SOURCE_DIR}" -B "${PROJECT_BINARY_DIR}/opencv"
  -G "${CMAKE_GENERATOR}" ${options}
  -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
  "-DOPENCV_EXTRA_MODULES_PATH=${PROJECT_SOURCE_DIR}/modules" -DLINESPACE_WARNINGS_AS_ERRORS=ON
  -DBUILD_LIST=core,imgproc,imgcodecs,ts,python3,linespace
  -DOPENCV_BUILD_TEST_MODULES_LIST=linespace -DOPENCV_BUILD_PERF_TEST_MODULES_LIST=linespace
  -DBUILD_TESTS=ON -DBUILD_PERF_TESTS=ON -DBUILD_opencv_apps=OFF -DBUILD_JAVA=OFF -DBUILD_ZLIB=OFF
  -DCPU_BASELINE=SSE2 -DCPU_DISPATCH=AVX2,AVX512_SKX
  -DOPENCL_INCLUDE_DIR=/usr/include/CL/
  -DPYTHON3_EXECUTABLE=/usr/bin/python3)

# OpenCV lists a module's files when it is configured, so that is done each time.
add_custom_target(in_tree ALL
  COMMAND ${configure}
  COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}/opencv"
  USES_TERMINAL VERBATIM)
