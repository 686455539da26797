// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// An edge map in OpenGL for the shaders that are compiled after pixels.glsl: what it takes to read
// it.

#ifndef OPENCV_LINESPACE_GL_PIXELS_HPP
#define OPENCV_LINESPACE_GL_PIXELS_HPP

#include "gl_device.hpp"
#include "plan.hpp"

namespace cv {
namespace linespace {

//! Refers to buffers of somebody else.
struct GlPixels
{
    const GlBuffer* image;      //!< a byte for each pixel, row after row
    const GlBuffer* directions; //!< two bytes each; null: the map is not oriented
    Size size;                  //!< of the image
    Cell frame;

    GlPixels() : image(0), directions(0) {}

    //! What a shader is compiled after that reads the map as bytes, from a binding on.
    std::string options(int block) const;
    void giveTo(GlLaunch& launch, int block) const;
    //! Of a launch, its own ones last.
    std::vector<int> numbers(const std::vector<int>& own) const;
};

//! Of a shader that counts the pixels of an oriented map.
std::string orientedOptions();

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_GL_PIXELS_HPP
