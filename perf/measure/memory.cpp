// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "sections.hpp"

#include "support/edge_maps.hpp"

#include "opencv2/linespace.hpp"

#include <iomanip>
#include <stdexcept>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace measure {

namespace {

long peakKibibytes()
{
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

//! The rise of the peak of resident memory by one call, in a child process that does nothing else.
long riseOf(const cv::Mat1b& edges)
{
    int channel[2];
    if (pipe(channel) != 0)
        throw std::runtime_error("cannot make a pipe");
    const pid_t child = fork();
    if (child == 0)
    {
        const long before = peakKibibytes();
        std::vector<cv::Vec3f> lines;
        cv::linespace::LineSpaceDetector::create(200, 100)->detect(edges, lines);
        const long rise = peakKibibytes() - before;
        const bool written = write(channel[1], &rise, sizeof(rise)) == sizeof(rise);
        _exit(written ? 0 : 1);
    }
    long rise = 0;
    const bool read = child > 0 && ::read(channel[0], &rise, sizeof(rise)) == sizeof(rise);
    close(channel[0]);
    close(channel[1]);
    if (child > 0)
        waitpid(child, nullptr, 0);
    if (!read)
        throw std::runtime_error("the child process that measures memory failed");
    return rise;
}

} // namespace

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
        const double bytes = 1024. * riseOf(edges);
        out << "| building.jpg | " << size.width << " x " << size.height << " | " << std::fixed
            << std::setprecision(1) << bytes / (1 << 20) << " | " << bytes / size.area() << " |\n";
    }
    out << "\n";
}

} // namespace measure
