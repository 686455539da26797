// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Included by the compiler before a sample of OpenCV (-include): a window becomes a file, named
// after its title, and no key is waited for.

#include <opencv2/highgui.hpp>
#include <opencv2/imgcodecs.hpp>

#define imshow(title, image) cv::imwrite(std::string(title) + ".png", image)
#define waitKey() 0
