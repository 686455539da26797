// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "edge_maps.hpp"

#include "opencv2/imgcodecs.hpp"
#include "opencv2/imgproc.hpp"

namespace support {

cv::Mat1b readPhotograph(const std::string& folder, const std::string& name)
{
    if (folder.empty())
        throw MissingImage(name + ": its folder is not given");
    const cv::Mat1b photograph = cv::imread(folder + "/" + name, cv::IMREAD_GRAYSCALE);
    if (photograph.empty())
        throw MissingImage("cannot read " + folder + "/" + name);
    return photograph;
}

cv::Mat1b scaled(const cv::Mat1b& photograph, cv::Size size)
{
    if (size.empty() || size == photograph.size())
        return photograph;
    cv::Mat1b result;
    cv::resize(photograph, result, size, 0, 0, cv::INTER_AREA);
    return result;
}

cv::Mat1b cannyEdges(const cv::Mat1b& photograph, CannyThresholds thresholds)
{
    cv::Mat1b edges;
    cv::Canny(photograph, edges, thresholds.low, thresholds.high, 3);
    return edges;
}

cv::Mat1b randomEdges(cv::Size size, double density, unsigned seed)
{
    cv::RNG random(0x9e3779b97f4a7c15u ^ seed);
    cv::Mat1f uniform(size);
    random.fill(uniform, cv::RNG::UNIFORM, 0.0, 1.0);
    return uniform < density;
}

} // namespace support
