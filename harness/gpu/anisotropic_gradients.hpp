#pragma once

#include "gpu/device.hpp"

namespace reliefbench::gpu {

/// Whether the device's anisotropic samplers choose level and direction by the gradients that textureGrad gives them,
/// within maxAnisotropy. Found by a shader when first asked for; the device must have samplerAnisotropy. lavapipe
/// (Mesa 22.3) takes differences of the coordinates between neighbouring invocations whatever gradients are given, and
/// knows no maximum.
bool anisotropy_takes_gradients(const Device& device);

}  // namespace reliefbench::gpu
