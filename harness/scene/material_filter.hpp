#pragma once

namespace reliefbench {

/// How the textures of the material are read where a hit is shaded: albedo, and the derivatives that normals come from.
/// The truth knows none of it, and reads level 0.
struct MaterialFilter {
    enum class Kind {
        /// Level 0, bilinear: there is no mip chain.
        lod0,
        /// Trilinear.
        mip,
        /// The same along the longer side of the pixel's footprint.
        anisotropic,
    };
    /// Of the texture coordinates, by which a level is chosen.
    enum class Gradients {
        /// Those where the pixel's ray enters the base, as published: they know nothing of the relief.
        before_search,
        /// Differences of neighbouring pixels' answers, however far apart these are.
        from_result,
        /// Of where neighbouring pixels' rays meet the tangent plane of the relief at the hit.
        analytic,
    };

    Kind kind = Kind::lod0;
    /// Of `anisotropic`: how often a footprint is longer than wide at most.
    int anisotropy = 16;
    /// Added to the level, by the sampler; 0 with `lod0`.
    double mip_bias = 0;
    Gradients gradients = Gradients::before_search;

    bool has_mips() const { return kind != Kind::lod0; }
    bool operator==(const MaterialFilter&) const = default;
};

}  // namespace reliefbench
