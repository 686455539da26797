// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// The program linespace: the straight lines of images and videos. See linespace --help.

#include <exception>
#include <iostream>

#include "options.hpp"
#include "run.hpp"
#include "text.hpp"

int main(int argc, char** argv)
{
    using namespace program;
    try
    {
        Options options;
        if (const std::optional<int> status = parse(argc, argv, options))
            return *status;
        return run(options);
    }
    catch (const UsageError& error)
    {
        std::cerr << "linespace: " << error.what() << " (see linespace --help)\n";
        return STATUS_USAGE;
    }
    catch (const std::exception& error)
    {
        std::cerr << "linespace: " << reasonOf(error) << '\n';
        return STATUS_SOME_FAILED;
    }
}
