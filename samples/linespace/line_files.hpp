// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Lines as JSON, CSV and SVG. samples/README.md documents what is in them.

#ifndef LINESPACE_SAMPLES_LINE_FILES_HPP
#define LINESPACE_SAMPLES_LINE_FILES_HPP

#include <string>

#include <nlohmann/json.hpp>

#include "finder.hpp"

namespace program {

//! Lines of one or more pictures in one JSON or CSV file.
class LineFile
{
public:
    LineFile(const Options& options, const std::string& path);

    void add(const Found& found);
    void addError(const std::string& input, const std::string& reason);

    //! Throws InputError if the file cannot be written.
    void write() const;

private:
    std::string path_;
    nlohmann::ordered_json json_;
    std::string csv_;
};

//! One picture with its lines. Throws InputError if the file cannot be written.
void writeSvg(const std::string& path, const Picture& picture, const Found& found);

} // namespace program

#endif // LINESPACE_SAMPLES_LINE_FILES_HPP
