#pragma once

namespace reliefbench {

/// How the relief shadows itself: docs/measurement.md has the methods. Every light is shadowed by its own.
struct SelfShadow {
    enum class Mode {
        off,
        /// A point is lit where the ray of the light through it meets nothing before it. The truth's lights are points
        /// at infinity.
        hard,
        /// An approximation of penumbrae. The truth's lights have their angular radius.
        soft,
    };
    enum class Soft {
        /// Dykhta, Parallax Occlusion Mapping in GLSL, 2013.
        dykhta,
        /// Tatarchuk, Practical Parallax Occlusion Mapping, ShaderX5, 2006, with the constants of the DirectX SDK's
        /// sample.
        tatarchuk,
    };

    Mode mode = Mode::off;
    Soft soft = Soft::dykhta;
    /// Hard: what lies nearer to the point than this, as a fraction of the relief's depth, does not shadow it.
    double hard_bias = 0.01;
    /// Dykhta: how far above its own place the point is taken to be, as a fraction of the relief's depth.
    double dykhta_bias = 0.05;
    /// Layers on the light's way with the light overhead and at the horizon: Dykhta's, and the hard shadows' where a
    /// technique has no search of its own.
    int min_steps = 15;
    int max_steps = 30;
    /// Tatarchuk: what a blocker's height above the light's way is multiplied by.
    double softening = 0.58;

    bool operator==(const SelfShadow&) const = default;
};

}  // namespace reliefbench
