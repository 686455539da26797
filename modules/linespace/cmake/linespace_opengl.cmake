# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

# The OpenGL path, in OpenCV's tree as outside: the shaders src/glsl/*.glsl as strings in
# gl_shaders_linespace.hpp, and LINESPACE_OPENGL for the files that use OpenGL. Nothing of OpenGL is
# needed for it, as that is loaded at run time. Without this file they are empty, and so they are on
# Windows, where nobody has tried it.

# linespace_shader_strings(FOLDER HEADER NAMESPACE...)
#
# Makes a header of the shaders of a folder, a string NAME_glsl for each NAME.glsl, within namespaces.
# They are kept as they are; they must not contain the delimiter )glsl".
function(linespace_shader_strings folder header)
  file(GLOB shaders CONFIGURE_DEPENDS "${folder}/*.glsl")
  set(definitions "")
  foreach(shader IN LISTS shaders)
    get_filename_component(name "${shader}" NAME_WE)
    file(READ "${shader}" code)
    string(APPEND definitions "const char ${name}_glsl[] = R\"glsl(${code})glsl\";\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${shader}")
  endforeach()
  string(REPLACE ";" " { namespace " opening "${ARGN}")
  string(REGEX REPLACE "[^;]+" "}" closing "${ARGN}")
  string(REPLACE ";" "" closing "${closing}")
  file(CONFIGURE OUTPUT "${header}" @ONLY CONTENT
"namespace ${opening} { namespace {
${definitions}}${closing}
")
endfunction()

set(linespace_opengl_dir "${CMAKE_CURRENT_BINARY_DIR}/opengl")
linespace_shader_strings("${CMAKE_CURRENT_SOURCE_DIR}/src/glsl"
                         "${linespace_opengl_dir}/gl_shaders_linespace.hpp" cv linespace)
file(GLOB linespace_opengl_files CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/src/gl_*.cpp")
set_source_files_properties(${linespace_opengl_files} PROPERTIES
  COMPILE_DEFINITIONS LINESPACE_OPENGL INCLUDE_DIRECTORIES "${linespace_opengl_dir}")
