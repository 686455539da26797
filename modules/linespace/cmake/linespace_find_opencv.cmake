# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# linespace_find_opencv(LEAST BELOW REASON)
#
# Finds OpenCV's core and imgproc, of a version from LEAST on and below BELOW. The variable REASON is
# empty if that worked, else it says why not. CMake's find_package takes any other OpenCV of the
# system where OpenCV_DIR, the variable or that of the environment, names a folder without one; here
# such a folder is refused. (It is a macro, because find_package sets variables.)
macro(linespace_find_opencv LEAST BELOW REASON)
  set(linespace_given_dir "")
  if(OpenCV_DIR)
    set(OpenCV_DIR "${OpenCV_DIR}" CACHE PATH "Folder of OpenCVConfig.cmake") # makes it absolute
    set(linespace_given_dir "${OpenCV_DIR}")
  endif()
  if(linespace_given_dir AND NOT EXISTS "${linespace_given_dir}/OpenCVConfig.cmake")
    set(${REASON} "OpenCV_DIR=${linespace_given_dir} has no OpenCVConfig.cmake")
  else()
    find_package(OpenCV QUIET COMPONENTS core imgproc)
    file(TO_CMAKE_PATH "$ENV{OpenCV_DIR}" linespace_environment_dir)
    if(NOT OpenCV_FOUND)
      set(${REASON} "there is no OpenCV with core and imgproc, or CMake does not find it: \
give -DOpenCV_DIR=FOLDER, the folder of OpenCVConfig.cmake. ${OpenCV_NOT_FOUND_MESSAGE}")
    elseif(NOT linespace_given_dir AND linespace_environment_dir
           AND NOT "${OpenCV_DIR}/" MATCHES "^${linespace_environment_dir}/")
      set(${REASON} "the environment's OpenCV_DIR=${linespace_environment_dir} has no \
OpenCVConfig.cmake where CMake looks for it; it found ${OpenCV_DIR}")
    elseif(OpenCV_VERSION VERSION_LESS "${LEAST}" OR NOT OpenCV_VERSION VERSION_LESS "${BELOW}")
      set(${REASON} "${OpenCV_DIR} is OpenCV ${OpenCV_VERSION}: must be at least ${LEAST} and \
below ${BELOW}; another one is chosen by -DOpenCV_DIR=FOLDER")
    else()
      set(${REASON} "")
    endif()
    if(${REASON} AND NOT linespace_given_dir)
      unset(OpenCV_DIR CACHE) # a next run would take it for given
    endif()
  endif()
endmacro()
