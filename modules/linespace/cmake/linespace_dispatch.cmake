# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# Compiles src/NAME.simd.hpp once per instruction set, as ocv_add_dispatched_file does inside
# OpenCV. src/NAME.dispatch.cpp includes NAME.simd_declarations.hpp, generated here, and chooses at
# run time by CV_CPU_DISPATCH; OPENCV_CPU_DISABLE=AVX512-SKX,AVX2 in the environment steps down.

# What OpenCV's flag of the same name stands for, and the smaller sets it implies.
set(linespace_AVX2_flags -mavx2 -mfma -mf16c -mpopcnt)
set(linespace_AVX2_sets SSE3 SSSE3 SSE4_1 POPCNT SSE4_2 FP16 FMA3 AVX AVX2)
# GCC 12 takes the undefined registers of its own intrinsics for variables that are not initialised.
set(linespace_AVX512_SKX_flags ${linespace_AVX2_flags}
    -mavx512f -mavx512cd -mavx512bw -mavx512dq -mavx512vl
    -Wno-uninitialized -Wno-maybe-uninitialized)
set(linespace_AVX512_SKX_sets ${linespace_AVX2_sets} AVX_512F AVX512_COMMON AVX512_SKX)

# Elsewhere the baseline alone is built; on 64-bit ARM it is NEON already.
set(linespace_dispatch_sets "")
set(linespace_dispatch_definitions "")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$" AND NOT MSVC)
  set(linespace_dispatch_sets AVX2 AVX512_SKX)
  foreach(set IN LISTS linespace_dispatch_sets)
    string(APPEND linespace_dispatch_definitions "#define CV_CPU_DISPATCH_COMPILE_${set} 1\n")
  endforeach()
endif()

# linespace_add_dispatched_file(TARGET NAME SET...), the sets in ascending order.
function(linespace_add_dispatched_file target name)
  set(source_dir "${CMAKE_CURRENT_SOURCE_DIR}/src")
  set(generated_dir "${CMAKE_CURRENT_BINARY_DIR}/dispatch")
  set(declarations "#define CV_CPU_OPTIMIZATION_DECLARATIONS_ONLY\n")
  set(modes BASELINE)
  foreach(set IN LISTS ARGN)
    if(NOT set IN_LIST linespace_dispatch_sets)
      continue()
    endif()
    string(TOLOWER "${set}" suffix)
    set(file "${generated_dir}/${name}.${suffix}.cpp")
    file(CONFIGURE OUTPUT "${file}" CONTENT
         "#include \"${source_dir}/precomp.hpp\"\n#include \"${source_dir}/${name}.simd.hpp\"\n")
    set(definitions CV_CPU_DISPATCH_MODE=${set})
    foreach(implied IN LISTS linespace_${set}_sets)
      list(APPEND definitions CV_CPU_COMPILE_${implied}=1)
    endforeach()
    set_source_files_properties("${file}" PROPERTIES
      COMPILE_DEFINITIONS "${definitions}" COMPILE_OPTIONS "${linespace_${set}_flags}")
    target_sources(${target} PRIVATE "${file}")
    string(APPEND declarations
           "#undef CV_CPU_OPTIMIZATION_NAMESPACE_BEGIN\n"
           "#undef CV_CPU_OPTIMIZATION_NAMESPACE_END\n"
           "#define CV_CPU_OPTIMIZATION_NAMESPACE_BEGIN namespace opt_${set} {\n"
           "#define CV_CPU_OPTIMIZATION_NAMESPACE_END }\n"
           "#include \"${source_dir}/${name}.simd.hpp\"\n")
    set(modes "${set}, ${modes}")
  endforeach()
  string(APPEND declarations "#define CV_CPU_DISPATCH_MODES_ALL ${modes}\n")
  file(CONFIGURE OUTPUT "${generated_dir}/${name}.simd_declarations.hpp"
       CONTENT "${declarations}")
  target_include_directories(${target} PRIVATE "${generated_dir}")
  set_property(TARGET ${target} PROPERTY linespace_dispatch_sets ${linespace_dispatch_sets})
endfunction()
