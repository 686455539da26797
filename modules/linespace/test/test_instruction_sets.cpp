// This file is part of the Line Space module for OpenCV.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

// Which instruction set the dispatched code runs on, and that results do not depend on it:
// test/simd/run_step.sh runs these tests once per set and compares the digests that they write.
//
// Environment: LINESPACE_EXPECT_SET, the set that must be the best one in use; LINESPACE_DIGESTS,
// the file that digests are written to.

#include "test_precomp.hpp"

#include "digests.hpp"

#include <cstdlib>
#include <fstream>

namespace opencv_test {
namespace {

//! What dispatched files are compiled for beside the baseline, ascending
//! (linespace_dispatch.cmake).
const int DISPATCHED[] = {CV_CPU_AVX2, CV_CPU_AVX512_SKX};

std::string environment(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::string bestSet()
{
    std::string best = "baseline";
    for (int feature : DISPATCHED)
        if (checkHardwareSupport(feature))
            best = getHardwareFeatureName(feature);
    return best;
}

TEST(Linespace_InstructionSets, best)
{
    const std::string expected = environment("LINESPACE_EXPECT_SET");
    std::cout << "Best instruction set in use: " << bestSet() << std::endl;
    if (!expected.empty())
    {
        EXPECT_EQ(expected, bestSet());
    }
}

// A name that OpenCV does not know disables nothing and costs a warning on stderr alone.
TEST(Linespace_InstructionSets, what_is_disabled_is_known_and_off)
{
    std::istringstream names(environment("OPENCV_CPU_DISABLE"));
    for (std::string name; std::getline(names, name, ',');)
    {
        bool isKnown = false;
        for (int feature = 0; feature < CV_HARDWARE_MAX_FEATURE && !isKnown; ++feature)
            if (getHardwareFeatureName(feature) == name)
            {
                isKnown = true;
                EXPECT_FALSE(checkHardwareSupport(feature)) << name;
            }
        EXPECT_TRUE(isKnown) << "'" << name << "' is no name of OpenCV's";
    }
}

TEST(Linespace_InstructionSets, digests)
{
    const std::string path = environment("LINESPACE_DIGESTS");
    if (path.empty())
        throw SkipTestException("LINESPACE_DIGESTS names no file");
    std::ofstream file(path.c_str());
    writeDigests(file);
    file.close();
    EXPECT_TRUE(file.good()) << "cannot write " << path;
}

} // namespace
} // namespace opencv_test
