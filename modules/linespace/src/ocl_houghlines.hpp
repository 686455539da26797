// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The drop-in's lines, counted on an OpenCL device: those that houghlines.cpp counts on the host.

#ifndef OPENCV_LINESPACE_OCL_HOUGHLINES_HPP
#define OPENCV_LINESPACE_OCL_HOUGHLINES_HPP

#include "grid_support.hpp"

namespace cv {
namespace linespace {

//! As the device reads it.
struct DeviceAngle
{
    float cosine, sine;
    int first, count, isAxisParallel;
};

//! Keeps its buffers between calls, but for very large ones.
class DeviceHoughLines
{
public:
    DeviceHoughLines() : room_(LEAST_ROOM) {}

    //! As Executor::countGridLines, with `cascade` for the table of the frame.
    void count(Executor& cascade, const EdgeMap& edges, const Plan& plan, const HoughGrid& grid,
               int threshold, std::vector<GridLine>& found);

private:
    enum
    {
        LEAST_ROOM = 1 << 12
    };

    int listPixels(const UMat& image, bool weighted);
    void listAngles(const HoughGrid& grid);
    void findSupported(Executor& cascade, const EdgeMap& edges, const Plan& plan,
                       const HoughGrid& grid, int needed);
    void readLines(int least, std::vector<GridLine>& found);
    void forgetLarge();

    UMat image_; //!< the edge map, where it was on the host
    UMat tiles_; //!< numbers of edge pixels
    UMat x_, y_, weights_;
    UMat angles_, runs_;
    std::vector<DeviceAngle> angleList_; //!< what angles_ holds
    std::vector<SampleRun> runList_;     //!< what runs_ holds
    int columns_;                        //!< of a row of votes: the most lines of an angle, and two
    VoteTables tables_;
    UMat supported_, votes_, starts_, lines_;
    int room_; //!< for so many lines
};

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_OCL_HOUGHLINES_HPP
