#pragma once

#include "gpu/device.hpp"
#include "support/temporary_folder.hpp"
#include "technique/technique.hpp"
#include "verify/check_list.hpp"
#include "verify/drawing.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace reliefbench::test {

/// One device for all tests of this executable. Every test ends with a look at what the validation layer said.
class VerifyTest : public testing::Test {
protected:
    static void SetUpTestSuite();
    void SetUp() override { messages_before_ = device().validation_messages().size(); }
    void TearDown() override;

    static const gpu::Device& device() { return *shared_device(); }

    /// Draws a shipped technique and compares it with the exact truth.
    static TruthComparison compare(const std::string& technique, const ParameterValues& changed,
                                   const CoordinateScene& scene, const View& view);

private:
    static std::unique_ptr<gpu::Device>& shared_device();
    std::size_t messages_before_ = 0;
};

/// A technique of this repository.
Technique shipped(const std::string& id);

/// Of all techniques of this repository.
std::vector<std::string> shipped_ids();

View parallel_view(double angle, double azimuth = -90);
View perspective_view(double angle, double azimuth = -90);

/// A procedural map in r16, or one from a function of texel indices.
HeightMap procedural(const std::string& name, Resolution size);
HeightMap map_of(Resolution size, const std::function<double(int x, int y)>& height);

/// Of a shader: of a technique's folder, or of harness/shaders.
struct Replacement {
    std::string file;
    std::string passage;
    std::string replacement;
};

/// A copy of a shipped technique, in a folder of its own that lives as long as the object, with passages replaced.
class BrokenCopy {
public:
    BrokenCopy(const std::string& id, const std::vector<Replacement>& replacements);
    BrokenCopy(const std::string& id, const std::string& file, const std::string& passage,
               const std::string& replacement)
        : BrokenCopy(id, {{file, passage, replacement}}) {}

    const Technique& technique() const { return technique_; }

private:
    TemporaryFolder root_;
    Technique technique_;
};

/// The checks that `body` adds to a list, until the first that fails.
std::vector<Check> checks_until_failure(const gpu::Device& device, const Technique& technique,
                                        const std::function<void(CheckList&)>& body);

}  // namespace reliefbench::test
