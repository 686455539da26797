// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The public interface of the module: straight lines of an edge map by the Line Space and the
// Cascaded Line Space (J. Hunz, A. K. Hebborn, S. Mueller, "A GPU based Real-Time Line Detector
// using a Cascaded 2D Line Space"), and a drop-in for cv::HoughLines. What is computed is written
// down in doc/algorithm.md; the sections named below are that document's.

#ifndef OPENCV_LINESPACE_HPP
#define OPENCV_LINESPACE_HPP

#include "opencv2/core.hpp"

/**
@defgroup linespace Straight lines by the Line Space
*/

namespace cv {
namespace linespace {

//! @addtogroup linespace
//! @{

//! How the votes of the chords are counted.
enum Method
{
    METHOD_EXACT = 0,    //!< every chord of the image by its own raster, O(n^3): the oracle
    METHOD_CASCADED = 1, //!< small cells first, then merged pairwise, O(n^2 log n)
    /** Strips of columns and of rows, merged pairwise, of which only the bundles of chords with the
    most votes are looked into (doc/algorithm.md, section 3b): the fastest for the strongest lines.
    It runs on the host; detect refuses BACKEND_OPENCL and BACKEND_OPENGL. compute and computeLevel
    give the tables of METHOD_CASCADED. The suppression must be SUPPRESS_RING with a radius of 1 or
    2, in place of which 2 is used; cell size, candidate ratio, pool size and pruning are ignored. */
    METHOD_STRIPS = 2
};

//! Which code counts them. All back ends give the same votes, bit by bit.
enum Backend
{
    //! The process-wide default, see setDefaultBackend; else OpenCL for a UMat where OpenCV uses a
    //! device, else the CPU path. It stands in for a device that fails, with a warning; a detector
    //! tries that again for images of another size, or after clear().
    BACKEND_AUTO = 0,
    BACKEND_REFERENCE = 1, //!< scalar code that follows the definition; slow
    BACKEND_CPU = 2,       //!< vectorised and threaded through cv::parallel_for_
    BACKEND_OPENCL = 3,    //!< votes on cv::ocl's device; throws where there is none
    BACKEND_OPENGL = 4     //!< compute shaders; throws where it is not available
};

//! How neighbouring candidates in the table of votes are thinned out.
enum Suppression
{
    SUPPRESS_RING = 0,   //!< keep the maxima of the (2 r + 1)^2 ring neighbourhood
    SUPPRESS_BLOCKS = 1, //!< the paper's pre-filter: keep one maximum of each aligned block
    SUPPRESS_GREEDY = 2  //!< the paper's alternative: strongest first, delete its neighbourhood
};

//! Which of the candidates are reported.
enum Selection
{
    SELECT_PEAKS = 0, //!< all, but those near a stronger one, see setSuppressionDistance
    SELECT_EXPLAIN =
        1 //!< also, edge pixels along a line do not vote for weaker lines: one line per edge
};

//! What happens to a line after its chord was chosen.
enum Refine
{
    REFINE_NONE = 0, //!< the chord itself
    REFINE_LEAST_SQUARES =
        1 //!< least squares on the edge pixels along the chord, then on given gradients
};

/** @brief Finds straight lines in a binary edge map.

Every pair of unit edges of the image border is one line, a chord; its votes are the edge pixels on
it. There is no angle step and no distance step: the sampling follows from the size of the image,
and so does the time of counting. See doc/algorithm.md, sections 1 to 4.

One detector is used by one thread at a time; different detectors may run in different threads at
once. A detector keeps its plan and its buffers for the next image of the same size; clear() frees
them.

Every method throws cv::Exception with a message that names the argument, its value and what is
allowed, and then leaves its outputs and the detector as they were.
*/
class CV_EXPORTS_W LineSpaceDetector : public Algorithm
{
public:
    /** @brief Creates a detector.
    @param threshold a line is reported if it has more votes (edge pixels) than this, >= 0. 0 asks
    for the a-contrario rule: a line is kept when images of random short chains of edge pixels, of
    the same density, are expected to have fewer than setFalseAlarms() chords as strong (section 7).
    @param maxLines how many lines are reported at most, the strongest first, >= 0; 0 means all.
    @param method one of #Method.
    @param cellSize wanted side of the cells of level 0 in pixels, 2 to 64; the cells that are
    really used follow from the image size (section 3), see getLevelCellSize. Ignored by
    #METHOD_EXACT, and by detect with #METHOD_STRIPS.
    @param backend one of #Backend.
    */
    CV_WRAP static Ptr<LineSpaceDetector> create(int threshold = 0, int maxLines = 0,
                                                 int method = METHOD_CASCADED, int cellSize = 8,
                                                 int backend = BACKEND_AUTO);

    /** @brief Finds the lines of an edge map.
    @param edges CV_8UC1, at least 1 x 1, Mat or UMat, any step; pixels other than 0 are edge
    pixels.
    @param lines N x 1 CV_32FC3, or std::vector<Vec3f>: (rho, theta, votes). rho in pixels and theta
    in radians are those of cv::HoughLines: the line is x cos(theta) + y sin(theta) = rho, pixel
    centres at integers. theta lies in the angle range. votes are the edge pixels on the chord of
    the frame the line came from. Order: votes descending, then the chord's border points (s, e)
    ascending.
    */
    CV_WRAP virtual void detect(InputArray edges, OutputArray lines) = 0;

    /** @brief Finds lines whose edge pixels also have the line's direction (section 6).

    An edge pixel votes for a chord only if its edge, orthogonal to the gradient (dx, dy), makes an
    angle of at most setOrientationTolerance() with it, up to half a direction bin (5.6 degrees).
    That keeps the pixels of other edges, of texture and noise from adding up to a line.
    @param edges as for detect above.
    @param dx,dy the gradient of the image at each pixel, e.g. of cv::Sobel: both CV_16SC1 or both
    CV_32FC1, of the size of edges, finite; a zero gradient votes for every direction. The length of
    the gradient does not matter for the votes. With #REFINE_LEAST_SQUARES the gradients within
    three pixels of a line, also where there is no edge pixel, tell its sub-pixel position (section
    5.2), so they are best given as they are, not thinned out or normalised. They count relative to
    the largest one at the line's edge pixels, so their unit does not matter, and one far larger
    than that counts as twice as much; one that is an edge pixel of the line itself outweighs the
    others. Where less than half of a line's edge pixels have gradients, or most of it is within
    four to six pixels of the image border, its edge pixels alone tell the position. Both empty
    (noArray()): the directions are estimated from the edge map, by its structure tensor.
    @param lines as for detect above; votes are the edge pixels of the right direction.
    */
    CV_WRAP virtual void detect(InputArray edges, InputArray dx, InputArray dy,
                                OutputArray lines) = 0;

    /** @brief The table of votes LS(s, e) over all pairs of border points of the frame.
    @param edges as for detect.
    @param lineSpace B x B CV_32SC1, B = 2 (width + height) of getFrameSize(); symmetric; pairs on
    one side of the frame are 0. Border points are numbered clockwise from the top-left corner. A
    table of more than 2^31 - 1 bytes (a frame of more than 23170 border points) is refused.
    */
    CV_WRAP virtual void compute(InputArray edges, OutputArray lineSpace) = 0;

    /** @brief The tables of all cells of one level of the cascade.
    @param edges as for detect.
    @param level 0 (the cells) to getLevelCount() - 1 (the frame, the same as compute); for
    #METHOD_EXACT 0.
    @param cascade CV_32SC1; with B the border points of a cell of the level, the entry (s, e) of
    the cell in row r and column c of the grid stands at (r B + s, c B + e). The size limit of
    compute holds here too.
    */
    CV_WRAP virtual void computeLevel(InputArray edges, int level, OutputArray cascade) = 0;

    /** @brief Size of the frame of the last call in pixels: the image, padded with zeros on the
    right and at the bottom to a whole number of cells. Empty before the first call. */
    CV_WRAP virtual Size getFrameSize() const = 0;
    //! Levels of the last call, 0 (finest) to count - 1; 1 for #METHOD_EXACT; 0 before the first
    //! call.
    CV_WRAP virtual int getLevelCount() const = 0;
    //! Size in pixels of a cell of a level of the last call; throws if there is no such level.
    CV_WRAP virtual Size getLevelCellSize(int level) const = 0;
    //! Cells per row and per column of a level of the last call; throws if there is no such level.
    CV_WRAP virtual Size getLevelGridSize(int level) const = 0;
    //! The back end that really ran in the last call, one of #Backend; -1 before the first call.
    CV_WRAP virtual int getActiveBackend() const = 0;

    /** @brief How well the lines of the last detect are known, by the pixels along them (section
    5.3).
    @param deviations N x 1 CV_32FC3, or std::vector<Vec3f>, a row for each line: the standard
    deviation of rho in pixels, that of theta in radians, and their correlation, -1 to 1. They tell
    what noise and the grid of pixels do to the position, not whether there is a line. Empty before
    the first call and where no line was found.
    */
    CV_WRAP virtual void getDeviations(OutputArray deviations) const = 0;

    /** @brief How long the stages of the last call took, in the order in which they ran.
    @param stages names: "edge map", "level 0" (the cells), "level 1" and so on (merges), and for
    lines "bounds" and "bundles" (what setPruning() does in the place of the last levels),
    "candidates", "ascent" (exact votes), "selection" (with refinement). Stages that a call does not
    have are missing; more may be added.
    @param milliseconds of wall clock, one for each name; the levels of #BACKEND_OPENGL by the
    device's clock, where it has one, and "candidates" the rest of the time until they are read. Both
    are empty before the first call.
    */
    CV_WRAP virtual void getStageTimes(CV_OUT std::vector<String>& stages,
                                       CV_OUT std::vector<double>& milliseconds) const = 0;

    //! Votes that a line must exceed, >= 0; 0: the a-contrario rule. Default 0.
    CV_WRAP virtual void setThreshold(int threshold) = 0;
    CV_WRAP virtual int getThreshold() const = 0;

    //! Most lines to report, >= 0; 0: all. Default 0.
    CV_WRAP virtual void setMaxLines(int maxLines) = 0;
    CV_WRAP virtual int getMaxLines() const = 0;

    //! One of #Method. Default #METHOD_CASCADED.
    CV_WRAP virtual void setMethod(int method) = 0;
    CV_WRAP virtual int getMethod() const = 0;

    //! Wanted side of the cells of level 0 in pixels, 2 to 64. Default 8.
    CV_WRAP virtual void setCellSize(int cellSize) = 0;
    CV_WRAP virtual int getCellSize() const = 0;

    //! One of #Backend. Default #BACKEND_AUTO.
    CV_WRAP virtual void setBackend(int backend) = 0;
    CV_WRAP virtual int getBackend() const = 0;

    //! One of #Suppression. Default #SUPPRESS_RING.
    CV_WRAP virtual void setSuppression(int suppression) = 0;
    CV_WRAP virtual int getSuppression() const = 0;

    /** Radius of the suppression in border points, 0 to 64; 0 keeps every chord above the
    threshold. For #SUPPRESS_BLOCKS the block is the smallest power of two of at least 2 r + 1
    border points. With #METHOD_CASCADED candidates move to maxima of the exact votes in a
    neighbourhood of this radius, 2 at most (section 4.2). Default 2. */
    CV_WRAP virtual void setSuppressionRadius(int radius) = 0;
    CV_WRAP virtual int getSuppressionRadius() const = 0;

    /** A line whose two ends inside the image are both within this many pixels of a stronger
    reported line is dropped, >= 0; 0 switches that off. Default 3. */
    CV_WRAP virtual void setSuppressionDistance(double distance) = 0;
    CV_WRAP virtual double getSuppressionDistance() const = 0;

    //! One of #Selection. Default #SELECT_PEAKS.
    CV_WRAP virtual void setSelection(int selection) = 0;
    CV_WRAP virtual int getSelection() const = 0;

    //! One of #Refine. Default #REFINE_LEAST_SQUARES.
    CV_WRAP virtual void setRefine(int refine) = 0;
    CV_WRAP virtual int getRefine() const = 0;

    /** Share of the threshold that a chord's votes in the cascade must exceed to be counted
    exactly, in [0, 1]: the cascade's votes differ a little from the exact ones. Default 0.75. */
    CV_WRAP virtual void setCandidateRatio(double ratio) = 0;
    CV_WRAP virtual double getCandidateRatio() const = 0;

    /** How many candidates, the strongest first, are counted exactly: at least this many and at
    least 16 maxLines, >= 1. With maxLines = 0 (all lines) every candidate is. Default 8192. */
    CV_WRAP virtual void setPoolSize(int poolSize) = 0;
    CV_WRAP virtual int getPoolSize() const = 0;

    /** Only edge pixels where the mask is not 0 vote. CV_8UC1 of the size of the edge map, checked
    when the detector runs; an empty array (noArray()) removes the mask. Not serialised. */
    CV_WRAP virtual void setMask(InputArray mask) = 0;
    CV_WRAP virtual void getMask(OutputArray mask) const = 0;

    /** Only lines with theta in [minTheta, maxTheta] are reported: radians, at most 1e6 in size,
    minTheta <= maxTheta, otherwise any interval, also through 0; rho's sign follows. An interval of
    pi or more means all directions, once each, in [minTheta, minTheta + pi). Default 0 to pi. */
    CV_WRAP virtual void setAngleRange(double minTheta, double maxTheta) = 0;
    CV_WRAP virtual void getAngleRange(CV_OUT double& minTheta, CV_OUT double& maxTheta) const = 0;

    /** For detect with gradients: how far the direction of an edge pixel may be from the centre of
    the direction bin (11.25 degrees wide) of the lines that it votes for, in degrees, more than 0,
    at most 90. Below 5.7 degrees there are directions, the axes among them, whose edges vote for no
    line. Default 22.5. */
    CV_WRAP virtual void setOrientationTolerance(double degrees) = 0;
    CV_WRAP virtual double getOrientationTolerance() const = 0;

    //! Expected number of false lines per image for threshold = 0, > 0. Default 1.
    CV_WRAP virtual void setFalseAlarms(double epsilon) = 0;
    CV_WRAP virtual double getFalseAlarms() const = 0;

    /** Whether detect leaves out the votes of bundles of chords that, by upper bounds, cannot belong
    to any candidate (section 4.4). The lines are the same; it takes less time and memory.
    Default true. */
    CV_WRAP virtual void setPruning(bool pruning) = 0;
    CV_WRAP virtual bool getPruning() const = 0;

    //! Whether an edge pixel counts with its value (1 to 255) instead of 1. Default false.
    CV_WRAP virtual void setEdgeWeights(bool edgeWeights) = 0;
    CV_WRAP virtual bool getEdgeWeights() const = 0;

    /** Most memory in MiB that the tables of votes of one call may take, with the edge map's
    copies, exact votes of candidates and the output of compute and computeLevel, >= 1; a size that
    needs more is refused with an exception before anything is allocated. With maxLines = 0, lists
    of candidates come on top: some 50 bytes for each chord that survives the suppression.
    Default 8192. */
    CV_WRAP virtual void setMemoryLimit(int mebibytes) = 0;
    CV_WRAP virtual int getMemoryLimit() const = 0;

    /** @brief Finds the lines of an edge map that is a texture of OpenGL.

    For graphics applications: chords are counted and the candidates found in the caller's context,
    where the texture is, and the candidates climb and are counted exactly. Only these and the edge
    pixels, as bits, are read from there, as lines are refined on the host; the pixels themselves with
    SELECT_EXPLAIN, SUPPRESS_GREEDY, or weights with threshold 0. State of the context that is
    touched is restored: the program, storage buffers and their bindings, texture unit 0 with its
    sampler, the active unit. Errors of OpenGL that are pending are lost, and commands of the
    caller that write the texture by image stores must be followed by a barrier for texture
    fetches.
    @param texture name of a GL_TEXTURE_2D of internal format GL_R8 or GL_R8UI, whose base level is
    the edge map: texels other than 0 are edge pixels, the first row is the upper one. A context with
    OpenGL 4.3 or OpenGL ES 3.1, or later, must be current in this thread.
    @param lines as for detect.

    The back end must be #BACKEND_AUTO or #BACKEND_OPENGL.
    */
    virtual void detectTexture(unsigned int texture, OutputArray lines) = 0;
};

/** @brief Finds lines in a binary image; takes what cv::HoughLines takes and means the same by it.

Computed by the Line Space (section 8). It differs from cv::HoughLines where users of that function
are unhappy: of lines within one (rho, theta) cell of each other only the strongest is reported, rho
has no bias, and min_theta and max_theta mean the same everywhere.

@param image CV_8UC1; pixels other than 0 vote. An empty image gives an empty result.
@param lines N x 1 CV_32FC2 (rho, theta), or CV_32FC3 (rho, theta, votes) if the caller's array has
that type. Order: votes descending, then theta, then rho ascending. votes are the pixels (or the sum
of their values) within rho / 2 of the line.
@param rho distance resolution in pixels, > 0.
@param theta angle resolution in radians, > 0.
@param threshold only lines with more votes are reported. 0 is a number of votes; with an OpenCV
before 5.1 so is a negative number.
@param srn,stn divisors of rho and theta for the multi-scale transform: the result has at least the
resolution rho / srn, theta / stn.
@param min_theta,max_theta theta lies in [min_theta, max_theta], radians, any real interval; of an
interval of pi or more, every line is reported once, in [min_theta, min_theta + pi).
@param use_edgeval count each pixel with its value.
@throws cv::Exception where the cv::HoughLines of the OpenCV that the module is built with throws.
Before OpenCV 5.1 these are: lines of another type, an image that is not CV_8UC1, min_theta larger
than max_theta, angles that are not finite, and steps that are 0, negative or not a number (but a very
large negative step just finds no lines). From 5.1 on, rho and theta must be positive and finite as
float and the threshold 0 or more, and an empty image of any type has no lines.
*/
CV_EXPORTS_W void HoughLines(InputArray image, OutputArray lines, double rho, double theta,
                             int threshold, double srn = 0, double stn = 0, double min_theta = 0,
                             double max_theta = CV_PI, bool use_edgeval = false);

/** @brief Sets the back end that #BACKEND_AUTO and HoughLines use, for the whole process;
thread-safe.
@param backend one of #Backend. */
CV_EXPORTS_W void setDefaultBackend(int backend);
//! The back end set last; #BACKEND_AUTO at the start.
CV_EXPORTS_W int getDefaultBackend();

/** @brief Where lines enter and leave an image.
@param lines N x 1 or 1 x N, CV_32FC2 or CV_32FC3: (rho, theta) or (rho, theta, votes).
@param imageSize in pixels, at least 1 x 1.
@param endPoints N x 1 CV_32FC4 (x1, y1, x2, y2), pixel centres at integers, on the border of the
rectangle [-0.5, width - 0.5] x [-0.5, height - 0.5]; four NaN for a line that misses the image. The
first point is the one with the smaller x, of equal ones the smaller y.
*/
CV_EXPORTS_W void lineEndPoints(InputArray lines, Size imageSize, OutputArray endPoints);

/** @brief Draws lines across an image.
@param image CV_8U, 1, 3 or 4 channels.
@param lines as for lineEndPoints; lines that miss the image are skipped.
@param color as for cv::line.
@param thickness in pixels, 1 to 32767.
*/
CV_EXPORTS_W void drawLines(InputOutputArray image, InputArray lines,
                            const Scalar& color = Scalar(0, 0, 255), int thickness = 1);

//! @}

} // namespace linespace
} // namespace cv

#endif // OPENCV_LINESPACE_HPP
