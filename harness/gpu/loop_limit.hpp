#pragma once

#include "gpu/device.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace reliefbench::gpu {

/// How many iterations the device lets the loops of an invocation have, all together; it then ends them without a word,
/// wherever they are. Found by a shader whose loop is longer, when first asked for; nothing where that ran to its end.
/// lavapipe (Mesa 22.3) counts 65,535 of all the invocations that it runs side by side, which take turns where they
/// differ: what each of them counted for itself would not tell.
std::optional<std::uint32_t> loop_limit(const Device& device);

/// "llvmpipe (LLVM 15.0.6, 256 bits) ends the loops of an invocation after 65535 iterations of all of them together".
std::string describe_loop_limit(const Device& device);

}  // namespace reliefbench::gpu
