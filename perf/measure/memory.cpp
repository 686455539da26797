// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "common/peak_memory.hpp"
#include "support/edge_maps.hpp"

#include "opencv2/linespace.hpp"

#include <iomanip>
#include <vector>

namespace measure {

void writeMemory(std::ostream& out, const Settings& settings)
{
    out << "## Memory\n\nRise of the peak of resident memory by the first `detect` of a process, "
           "cascaded, CPU path.\n\n"
           "| image | size | MiB | bytes per pixel |\n| --- | --- | ---: | ---: |\n";
    const cv::Mat1b photograph = support::readPhotograph(settings.data, "building.jpg");
    cv::setNumThreads(1); // a child of fork has no other threads
    for (const cv::Size size : {cv::Size(512, 512), cv::Size(1920, 1080), cv::Size(4096, 4096)})
    {
        const cv::Mat1b edges = support::cannyEdges(support::scaled(photograph, size));
        const auto detect = [&]
        {
            std::vector<cv::Vec3f> lines;
            cv::linespace::LineSpaceDetector::create(200, 100)->detect(edges, lines);
        };
        const double bytes = 1024. * riseOfPeakMemory(detect);
        out << "| building.jpg | " << size.width << " x " << size.height << " | " << std::fixed
            << std::setprecision(1) << bytes / (1 << 20) << " | " << bytes / size.area() << " |\n";
    }
    out << "\n";
}

} // namespace measure
