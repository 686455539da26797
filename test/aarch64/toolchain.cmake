# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# 64-bit ARM with Debian's cross compiler, and the libraries that make_sysroot.sh unpacked into
# build/aarch64-sysroot. Programs run under qemu-user.

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

get_filename_component(CMAKE_SYSROOT "${CMAKE_CURRENT_LIST_DIR}/../../build/aarch64-sysroot" ABSOLUTE)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)

# On an installed system links of update-alternatives lead to these two libraries.
set(lib /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE})
add_link_options(LINKER:-rpath-link,${CMAKE_SYSROOT}${lib}/blas:${CMAKE_SYSROOT}${lib}/lapack)
set(CMAKE_CROSSCOMPILING_EMULATOR
    qemu-aarch64 -L "${CMAKE_SYSROOT}" -E "LD_LIBRARY_PATH=${lib}/blas:${lib}/lapack")
