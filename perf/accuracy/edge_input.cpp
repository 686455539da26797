// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "edge_input.hpp"

#include "opencv2/imgproc.hpp"

namespace accuracy {

EdgeInput edgeInput(const cv::Mat& image, const EdgeSettings& settings)
{
    EdgeInput input;
    if (settings.smooth)
        cv::GaussianBlur(image, input.grey, cv::Size(5, 5), 1.2);
    else
        input.grey = image;
    cv::Canny(input.grey, input.edges, settings.low, settings.high);
    cv::Sobel(input.grey, input.dx, CV_16S, 1, 0);
    cv::Sobel(input.grey, input.dy, CV_16S, 0, 1);
    return input;
}

} // namespace accuracy
