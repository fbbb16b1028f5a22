#pragma once

#include "gpu/shader_compiler.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace reliefbench::gpu {

/// An instruction that reads an image, and where it stands in the sources.
struct Fetch {
    enum class Kind {
        /// Through a filter: texture, textureLod, textureGrad, textureProj, ...
        sampled,
        /// One texel of a sampled image: texelFetch.
        texel,
        /// textureGather.
        gather,
        /// A storage image: imageLoad and the atomics.
        stored,
    };
    Kind kind = Kind::sampled;
    /// As it was included; empty where the module has no lines.
    std::string file;
    std::uint32_t line = 0;

    bool operator==(const Fetch&) const = default;
};

/// In the module's order. A macro's instructions stand where it is used. Lines are those of a module as
/// ShaderSource::inspect gets it.
std::vector<Fetch> find_fetches(const SpirV& module);

}  // namespace reliefbench::gpu
