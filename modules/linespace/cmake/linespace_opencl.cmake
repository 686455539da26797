# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# The OpenCL programs src/opencl/*.cl as strings in opencl_kernels_linespace.hpp, with the names and
# types that OpenCV's own cl2cpp.cmake gives them in its tree: an installed OpenCV has no such script.
# The sources are kept as they are; they must not contain the delimiter )cl".

set(linespace_opencl_dir "${CMAKE_CURRENT_BINARY_DIR}/opencl")
file(GLOB linespace_programs CONFIGURE_DEPENDS src/opencl/*.cl)
set(declarations "")
set(definitions "")
foreach(program IN LISTS linespace_programs)
  get_filename_component(name "${program}" NAME_WE)
  file(READ "${program}" code)
  string(MD5 hash "${code}")
  string(APPEND declarations "extern internal::ProgramEntry ${name}_oclsrc;\n")
  string(APPEND definitions "internal::ProgramEntry ${name}_oclsrc = {\"linespace\", \"${name}\",\n"
                            "R\"cl(${code})cl\", \"${hash}\", 0};\n")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${program}")
endforeach()
file(CONFIGURE OUTPUT "${linespace_opencl_dir}/opencl_kernels_linespace.hpp" @ONLY CONTENT
"#include <opencv2/core/ocl.hpp>
#include <opencv2/core/ocl_genbase.hpp>
namespace cv { namespace ocl { namespace linespace {
${declarations}}}}
")
file(CONFIGURE OUTPUT "${linespace_opencl_dir}/opencl_kernels_linespace.cpp" @ONLY CONTENT
"#include \"opencl_kernels_linespace.hpp\"
namespace cv { namespace ocl { namespace linespace {
${definitions}}}}
")
target_sources(opencv_linespace PRIVATE "${linespace_opencl_dir}/opencl_kernels_linespace.cpp")
target_include_directories(opencv_linespace PRIVATE "${linespace_opencl_dir}")
