# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# linespace_find_opencv(LEAST BELOW REASON)
#
# Finds OpenCV's core and imgproc, of a version from LEAST on and below BELOW. The variable REASON
# is empty if that worked, else it says why not. Where an OpenCV_DIR names a folder without an
# OpenCV, CMake's find_package takes any other one; this macro refuses. The first of these decides:
#   1. the variable OpenCV_DIR, the folder of OpenCVConfig.cmake;
#   2. the variables OpenCV_ROOT and CMAKE_PREFIX_PATH, if CMake finds an OpenCV by them;
#   3. the environment's OpenCV_DIR, that folder or the prefix of an installed OpenCV;
#   4. wherever else CMake looks, if the environment has no OpenCV_DIR.
# An OpenCV that an earlier run found by 2 to 4 is kept, unless the environment has another
# OpenCV_DIR now. (It is a macro, because find_package sets variables.)
macro(linespace_find_opencv LEAST BELOW REASON)
  linespace_given_opencv_dir(linespace_given_dir)
  set(linespace_environment_dir "$ENV{OpenCV_DIR}")
  set(${REASON} "")
  if(linespace_given_dir)
    set(OpenCV_DIR "${linespace_given_dir}")
    find_package(OpenCV QUIET CONFIG COMPONENTS core imgproc
                 PATHS "${linespace_given_dir}" NO_DEFAULT_PATH)
    if(NOT EXISTS "${linespace_given_dir}/OpenCVConfig.cmake")
      set(${REASON} "OpenCV_DIR=${linespace_given_dir} has no OpenCVConfig.cmake")
    elseif(NOT "${OpenCV_DIR}" STREQUAL "${linespace_given_dir}")
      set(${REASON} "the version file in OpenCV_DIR=${linespace_given_dir} says that this OpenCV \
does not suit the build, as one for another processor does not")
    endif()
  elseif(linespace_environment_dir)
    # CMake searches the environment's CMAKE_PREFIX_PATH together with its OpenCV_DIR.
    set(linespace_prefix_path "$ENV{CMAKE_PREFIX_PATH}")
    set(ENV{CMAKE_PREFIX_PATH} "")
    find_package(OpenCV QUIET CONFIG COMPONENTS core imgproc NO_SYSTEM_ENVIRONMENT_PATH
                 NO_CMAKE_SYSTEM_PATH NO_CMAKE_PACKAGE_REGISTRY NO_CMAKE_SYSTEM_PACKAGE_REGISTRY)
    set(ENV{CMAKE_PREFIX_PATH} "${linespace_prefix_path}")
    if(NOT OpenCV_DIR)
      set(${REASON} "the environment's OpenCV_DIR=${linespace_environment_dir} has no \
OpenCVConfig.cmake that CMake accepts, neither there nor below it as in an installed OpenCV; \
OpenCV_ROOT and CMAKE_PREFIX_PATH have none either")
    endif()
  else()
    find_package(OpenCV QUIET CONFIG COMPONENTS core imgproc)
    if(NOT OpenCV_DIR)
      set(${REASON} "there is no OpenCV, or CMake does not find it: give -DOpenCV_DIR=FOLDER, the \
folder of OpenCVConfig.cmake")
    endif()
  endif()

  if(NOT ${REASON} AND NOT OpenCV_FOUND)
    set(${REASON} "the OpenCVConfig.cmake in ${OpenCV_DIR} does not give OpenCV's core and \
imgproc. ${OpenCV_NOT_FOUND_MESSAGE}")
  elseif(NOT ${REASON} AND
         (OpenCV_VERSION VERSION_LESS "${LEAST}" OR NOT OpenCV_VERSION VERSION_LESS "${BELOW}"))
    set(${REASON} "${OpenCV_DIR} is OpenCV ${OpenCV_VERSION}: must be at least ${LEAST} and \
below ${BELOW}; another one is chosen by -DOpenCV_DIR=FOLDER")
  endif()

  # The next run finds in the cache what was given, else what was found.
  if(linespace_given_dir)
    if(DEFINED CACHE{OpenCV_DIR} AND NOT "$CACHE{OpenCV_DIR}" STREQUAL "${linespace_given_dir}")
      set(OpenCV_DIR "${linespace_given_dir}" CACHE PATH "Folder of OpenCVConfig.cmake" FORCE)
    endif()
    set(OpenCV_DIR "${linespace_given_dir}")
  elseif(${REASON})
    unset(OpenCV_DIR CACHE)
  else()
    set(OpenCV_DIR "${OpenCV_DIR}" CACHE PATH "Folder of the OpenCV that was found" FORCE)
    set(LINESPACE_FOUND_OPENCV_DIR "${OpenCV_DIR}" CACHE INTERNAL "OpenCV_DIR where it was found")
    set(LINESPACE_ENVIRONMENT_OPENCV_DIR "${linespace_environment_dir}" CACHE INTERNAL
        "The environment's OpenCV_DIR when LINESPACE_FOUND_OPENCV_DIR was found")
  endif()
  unset(linespace_given_dir)
  unset(linespace_environment_dir)
  unset(linespace_prefix_path)
endmacro()

# linespace_given_opencv_dir(GIVEN)
#
# GIVEN becomes the absolute path of the folder that the variable OpenCV_DIR names, or empty. A
# folder that an earlier run found is forgotten if the environment has another OpenCV_DIR now or no
# OpenCV is there any more.
function(linespace_given_opencv_dir GIVEN)
  set(${GIVEN} "" PARENT_SCOPE)
  if(NOT OpenCV_DIR)
    return()
  endif()
  get_property(help CACHE OpenCV_DIR PROPERTY HELPSTRING) # -D on the command line changes it
  if(help STREQUAL "Folder of the OpenCV that was found"
     AND "${OpenCV_DIR}" STREQUAL "${LINESPACE_FOUND_OPENCV_DIR}")
    set(now "$ENV{OpenCV_DIR}")
    if((now AND NOT "${now}" STREQUAL "${LINESPACE_ENVIRONMENT_OPENCV_DIR}")
       OR NOT EXISTS "${OpenCV_DIR}/OpenCVConfig.cmake")
      unset(OpenCV_DIR CACHE)
      return()
    endif()
  endif()
  get_property(type CACHE OpenCV_DIR PROPERTY TYPE)
  if(type STREQUAL "UNINITIALIZED")
    # CMake takes -DOpenCV_DIR=FOLDER relative to the folder where it was started.
    set(OpenCV_DIR "${OpenCV_DIR}" CACHE PATH "Folder of OpenCVConfig.cmake")
  endif()
  get_filename_component(given "${OpenCV_DIR}" ABSOLUTE)
  set(${GIVEN} "${given}" PARENT_SCOPE)
endfunction()
