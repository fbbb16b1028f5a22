#include "gpu/anisotropic_gradients.hpp"

#include <gtest/gtest.h>

namespace reliefbench::gpu {
namespace {

TEST(AnisotropicGradients, AreAskedForWithoutAWordOfTheValidationLayer) {
    const Device device({.choice = "", .validation = true});
    if (!device.info().has_feature("samplerAnisotropy")) GTEST_SKIP() << "the device has no anisotropy";
    const bool takes = anisotropy_takes_gradients(device);
    EXPECT_EQ(anisotropy_takes_gradients(device), takes);
    EXPECT_TRUE(device.validation_messages().empty());
    // Drivers known: SwiftShader does, lavapipe of Mesa 22.3 does not.
    if (device.info().name.find("SwiftShader") != std::string::npos) {
        EXPECT_TRUE(takes);
    }
    if (device.info().driver_version.starts_with("Mesa 22.3")) {
        EXPECT_FALSE(takes);
    }
}

}  // namespace
}  // namespace reliefbench::gpu
