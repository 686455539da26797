// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "test_precomp.hpp"

#include "generators.hpp"
#include "test_support.hpp"

#include <cstdlib>

namespace opencv_test {
namespace generators {

Mat1b randomEdges(const Size& size, double density, unsigned seed)
{
    RNG rng((uint64)seed * 2654435761u + 12345);
    Mat1b edges(size, (uchar)0);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
        {
            const bool isEdge = rng.uniform(0.0, 1.0) < density;
            const uchar value = (uchar)rng.uniform(1, 256);
            if (isEdge)
                edges(y, x) = value;
        }
    return edges;
}

Mat1b whiteEdges(const Size& size)
{
    return Mat1b(size, (uchar)255);
}

Mat1b onePixel(const Size& size, const Point& pixel)
{
    Mat1b edges(size, (uchar)0);
    edges(pixel) = 255;
    return edges;
}

void addLine(Mat1b& edges, double rho, double theta)
{
    const double c = std::cos(theta), s = std::sin(theta);
    const bool alongX = std::abs(s) >= std::abs(c);
    const int length = alongX ? edges.cols : edges.rows;
    for (int major = 0; major < length; ++major)
    {
        const int minor = cvRound(alongX ? (rho - major * c) / s : (rho - major * s) / c);
        const Point pixel = alongX ? Point(major, minor) : Point(minor, major);
        if (Rect(Point(), edges.size()).contains(pixel))
            edges(pixel) = 255;
    }
}

Mat1b linesInNoise(const Size& size, int count, double noise, unsigned seed,
                   std::vector<Vec2d>& lines)
{
    RNG rng((uint64)seed * 2654435761u + 54321);
    Mat1b edges = randomEdges(size, noise, seed);
    lines.clear();
    while ((int)lines.size() < count)
    {
        // Through a point of the middle half, so that every line is long.
        const double theta = rng.uniform(0.0, CV_PI);
        const double x = rng.uniform(0.25, 0.75) * size.width,
                     y = rng.uniform(0.25, 0.75) * size.height;
        const Vec2d line(x * std::cos(theta) + y * std::sin(theta), theta);
        bool isApart = true;
        for (size_t i = 0; i < lines.size(); ++i)
        {
            double turn = std::abs(line[1] - lines[i][1]);
            turn = std::min(turn, CV_PI - turn);
            isApart = isApart && (turn > CV_PI / 18 ||
                                  (turn < CV_PI / 90 && std::abs(line[0] - lines[i][0]) > 20));
        }
        if (!isApart)
            continue;
        lines.push_back(line);
        addLine(edges, line[0], line[1]);
    }
    return edges;
}

Mat asWindow(const Mat& edges)
{
    Mat large(edges.rows + 5, edges.cols + 7, edges.type(), Scalar::all(255));
    Mat window = large(Rect(3, 2, edges.cols, edges.rows));
    edges.copyTo(window);
    return window;
}

Mat1b photographEdges(const std::string& name, int maxSide)
{
    const char* folder = std::getenv("LINESPACE_SAMPLES_DATA");
    if (!folder || !*folder)
        skipTest("LINESPACE_SAMPLES_DATA is not set: the folder samples/data of OpenCV's sources");
    Mat photograph = imread(std::string(folder) + "/" + name, IMREAD_GRAYSCALE);
    if (photograph.empty())
        skipTest("cannot read " + std::string(folder) + "/" + name);
    const double scale = (double)maxSide / std::max(photograph.cols, photograph.rows);
    if (scale < 1)
        resize(photograph, photograph, Size(), scale, scale, INTER_AREA);
    Mat1b edges;
    Canny(photograph, edges, 50, 150);
    return edges;
}

} // namespace generators
} // namespace opencv_test
