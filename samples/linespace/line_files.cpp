// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

#include "line_files.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

#include "frames.hpp"
#include "naming.hpp"
#include "text.hpp"

#include "opencv2/core/utility.hpp"
#include "opencv2/imgcodecs.hpp"

namespace program {

namespace {

using Json = nlohmann::ordered_json;

void writeText(const std::string& path, const std::string& text)
{
    errno = 0;
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        throw InputError(path + " cannot be written: " + std::strerror(errno));
}

Json parametersOf(const Options& o)
{
    Json edges;
    if (o.edgeMap)
        edges = {{"edgeMap", true}};
    else
        edges = {{"canny", {o.cannyLow, o.cannyHigh}}, {"blur", o.blur}};
    return {{"threshold", o.threshold},
            {"maxLines", o.maxLines},
            {"angleRange", {o.minAngle, o.maxAngle}},
            {"selection", o.selection},
            {"oriented", o.oriented},
            {"minDistance", o.minDistance},
            {"method", o.method},
            {"cellSize", o.cellSize},
            {"backend", o.backend},
            {"edges", edges},
            {"mask", o.mask.empty() ? Json() : Json(o.mask)}};
}

Json toJson(const Found& found)
{
    Json picture = {{"image", found.input}};
    if (found.frame >= 0)
    {
        picture["frame"] = found.frame;
        picture["seconds"] = found.seconds;
    }
    picture["width"] = found.size.width;
    picture["height"] = found.size.height;
    picture["edgePixels"] = found.edgePixels;
    picture["milliseconds"] = found.milliseconds;
    picture["backend"] = found.backend;
    picture["lines"] = Json::array();
    for (std::size_t i = 0; i < found.lines.size(); ++i)
    {
        const cv::Vec3f& line = found.lines[i];
        const cv::Vec4f& ends = found.endPoints[i];
        picture["lines"].push_back({{"rho", line[0]},
                                    {"theta", line[1]},
                                    {"votes", cvRound(line[2])},
                                    {"endPoints", {ends[0], ends[1], ends[2], ends[3]}}});
    }
    return picture;
}

// RFC 4180.
std::string csvField(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::string toCsv(const Found& found)
{
    std::string rows;
    const std::string frame = found.frame >= 0 ? std::to_string(found.frame) : "";
    for (std::size_t i = 0; i < found.lines.size(); ++i)
    {
        const cv::Vec3f& line = found.lines[i];
        const cv::Vec4f& ends = found.endPoints[i];
        rows += csvField(found.input) + "," + frame +
                format(",%zu,%.9g,%.9g,%d,%.9g,%.9g,%.9g,%.9g\n", i + 1, line[0], line[1],
                       cvRound(line[2]), ends[0], ends[1], ends[2], ends[3]);
    }
    return rows;
}

std::string base64(const std::vector<unsigned char>& bytes)
{
    const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned bits = 0;
        for (std::size_t j = 0; j < 3; ++j)
            bits = bits << 8 | (j < count ? bytes[i + j] : 0u);
        for (std::size_t j = 0; j < 4; ++j)
            text += j <= count ? digits[bits >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

std::string xmlText(const std::string& text)
{
    std::string escaped;
    for (const char c : text)
    {
        if (c == '&')
            escaped += "&amp;";
        else if (c == '<')
            escaped += "&lt;";
        else if (c == '>')
            escaped += "&gt;";
        else if (c == '"')
            escaped += "&quot;";
        else
            escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return escaped;
}

} // namespace

LineFile::LineFile(const Options& options, const std::string& path)
    : path_(path), csv_("image,frame,line,rho,theta,votes,x1,y1,x2,y2\n")
{
    json_ = {{"program", "linespace " LINESPACE_VERSION},
             {"opencv", cv::getVersionString()},
             {"parameters", parametersOf(options)},
             {"images", Json::array()}};
}

void LineFile::add(const Found& found)
{
    if (lineFormat(path_) == ".csv")
        csv_ += toCsv(found);
    else
        json_["images"].push_back(toJson(found));
}

void LineFile::addError(const std::string& input, const std::string& reason)
{
    json_["images"].push_back({{"image", input}, {"error", reason}});
}

void LineFile::write() const
{
    if (lineFormat(path_) == ".csv")
        writeText(path_, csv_);
    else // names of files need not be UTF-8, JSON must be
        writeText(path_, json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

// Pixel centres are at integers, as everywhere in OpenCV: hence the halves. The picture is inside,
// so that the file can be sent and shown anywhere.
void writeSvg(const std::string& path, const Picture& picture, const Found& found)
{
    std::vector<unsigned char> bytes;
    cv::imencode(".jpg", picture.colors, bytes, {cv::IMWRITE_JPEG_QUALITY, 92});
    const int width = found.size.width, height = found.size.height;
    const double thickness = std::max(1.0, std::hypot(width, height) / 450);
    std::string svg = format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
                             "viewBox=\"-0.5 -0.5 %d %d\">\n",
                             width, height, width, height);
    svg += "  <title>" + xmlText(found.input) + "</title>\n";
    svg +=
        format("  <image x=\"-0.5\" y=\"-0.5\" width=\"%d\" height=\"%d\" href=\"data:image/jpeg;"
               "base64,",
               width, height);
    svg += base64(bytes) + "\"/>\n";
    svg += format("  <g stroke=\"#ff3c28\" stroke-width=\"%.2f\">\n", thickness);
    for (std::size_t i = 0; i < found.lines.size(); ++i)
    {
        const cv::Vec4f& ends = found.endPoints[i];
        if (std::isnan(ends[0]))
            continue; // misses the image
        svg += format("    <line x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" y2=\"%.2f\"><title>rho %.2f, "
                      "theta %.4f, %d votes</title></line>\n",
                      ends[0], ends[1], ends[2], ends[3], found.lines[i][0], found.lines[i][1],
                      cvRound(found.lines[i][2]));
    }
    svg += "  </g>\n</svg>\n";
    writeText(path, svg);
}

} // namespace program
