# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Installs the library, the public header, the CMake package opencv_linespace and the pkg-config
# file of that name. No installed file contains the prefix, so the tree may be moved.

include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/opencv_linespace")
set(pkgconfig_dir "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH pkgconfig_to_prefix "/${pkgconfig_dir}" "/")
string(REGEX REPLACE "/$" "" pkgconfig_to_prefix "${pkgconfig_to_prefix}")

install(TARGETS opencv_linespace EXPORT opencv_linespace)
install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp")
install(EXPORT opencv_linespace FILE opencv_linespace-targets.cmake DESTINATION "${package_dir}")

# The library needs the OpenCV that it was built with, of any patch level.
set(opencv_least "${OpenCV_VERSION_MAJOR}.${OpenCV_VERSION_MINOR}")
math(EXPR next_minor "${OpenCV_VERSION_MINOR} + 1")
set(opencv_below "${OpenCV_VERSION_MAJOR}.${next_minor}")
configure_file(cmake/opencv_linespace-config.cmake.in opencv_linespace-config.cmake @ONLY)
write_basic_package_version_file(opencv_linespace-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/opencv_linespace-config.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/opencv_linespace-config-version.cmake"
              cmake/linespace_find_opencv.cmake
        DESTINATION "${package_dir}")

list(TRANSFORM CMAKE_DL_LIBS PREPEND "-l" OUTPUT_VARIABLE pkgconfig_private_libs)
configure_file(cmake/opencv_linespace.pc.in opencv_linespace.pc @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/opencv_linespace.pc" DESTINATION "${pkgconfig_dir}")
