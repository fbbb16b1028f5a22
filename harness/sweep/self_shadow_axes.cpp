#include "sweep/self_shadow_axes.hpp"

#include "sweep/axis_kinds.hpp"

namespace reliefbench {

namespace {

constexpr NumberRange fractions{.minimum = 0, .maximum = 1};
constexpr NumberRange softenings{.minimum = 0, .maximum = 1000};
constexpr IntegerRange shadow_steps{.minimum = 1, .maximum = 65536};

bool has_hard_shadows(const View& view) {
    return view.self_shadow.mode == SelfShadow::Mode::hard;
}

bool has_soft_shadows(const View& view) {
    return view.self_shadow.mode == SelfShadow::Mode::soft;
}

bool has_dykhta_shadows(const View& view) {
    return has_soft_shadows(view) && view.self_shadow.soft == SelfShadow::Soft::dykhta;
}

bool has_tatarchuk_shadows(const View& view) {
    return has_soft_shadows(view) && view.self_shadow.soft == SelfShadow::Soft::tatarchuk;
}

bool has_shadow_steps(const View& view) {
    return has_hard_shadows(view) || has_dykhta_shadows(view);
}

}  // namespace

std::vector<ViewAxis> self_shadow_axes() {
    std::vector<ViewAxis> axes;
    axes.push_back(word_axis<SelfShadow::Mode>(
        "self_shadow",
        {.help = "whether the relief shadows itself: hard, lights are points; soft, they have their angular_radius",
         .also_called = {"shadow", "shadows", "self_shadows", "self_shadowing"}},
        {"off", "hard", "soft"}, [](auto& key) -> auto& { return key.view.self_shadow.mode; }));
    axes.push_back(only_where(
        has_soft_shadows, word_axis<SelfShadow::Soft>(
                              "soft_shadow", {.help = "how soft shadows are approximated; self_shadow=soft only"},
                              {"dykhta", "tatarchuk"}, [](auto& key) -> auto& { return key.view.self_shadow.soft; })));
    axes.push_back(only_where(has_hard_shadows,
                              number_axis(
                                  "hard_shadow_bias",
                                  {.unit = "height_scale",
                                   .help = "what lies nearer to a point does not shadow it; self_shadow=hard only",
                                   .also_called = {"bias", "shadow_bias"}},
                                  fractions, [](auto& key) -> auto& { return key.view.self_shadow.hard_bias; })));
    axes.push_back(only_where(has_dykhta_shadows,
                              number_axis(
                                  "dykhta_bias",
                                  {.unit = "height_scale",
                                   .help = "how far above its place a point is taken to be; soft_shadow=dykhta only",
                                   .also_called = {"bias", "shadow_bias"}},
                                  fractions, [](auto& key) -> auto& { return key.view.self_shadow.dykhta_bias; })));
    axes.push_back(only_where(has_shadow_steps,
                              number_axis(
                                  "shadow_min_steps",
                                  {.unit = "steps",
                                   .help = "layers on the way of a light overhead; dykhta, and hard where a "
                                           "technique's shadow_search is uniform_layers",
                                   .also_called = {"shadow_steps", "shadow_samples"}},
                                  shadow_steps, [](auto& key) -> auto& { return key.view.self_shadow.min_steps; })));
    axes.push_back(only_where(has_shadow_steps,
                              number_axis(
                                  "shadow_max_steps",
                                  {.unit = "steps",
                                   .help = "layers on the way of a light at the horizon",
                                   .also_called = {"shadow_steps", "shadow_samples"}},
                                  shadow_steps, [](auto& key) -> auto& { return key.view.self_shadow.max_steps; })));
    axes.push_back(
        only_where(has_tatarchuk_shadows,
                   number_axis(
                       "shadow_softening",
                       {.help = "factor of a blocker's height above the light's way; soft_shadow=tatarchuk only",
                        .also_called = {"softness", "shadow_softness"}},
                       softenings, [](auto& key) -> auto& { return key.view.self_shadow.softening; })));
    return axes;
}

void reset_unused(SelfShadow& self_shadow) {
    const SelfShadow given = self_shadow;
    self_shadow = SelfShadow{};
    self_shadow.mode = given.mode;
    const bool dykhta = given.mode == SelfShadow::Mode::soft && given.soft == SelfShadow::Soft::dykhta;
    if (given.mode == SelfShadow::Mode::soft) self_shadow.soft = given.soft;
    if (given.mode == SelfShadow::Mode::hard) self_shadow.hard_bias = given.hard_bias;
    if (dykhta) self_shadow.dykhta_bias = given.dykhta_bias;
    if (given.mode == SelfShadow::Mode::hard || dykhta) {
        self_shadow.min_steps = given.min_steps;
        self_shadow.max_steps = given.max_steps;
    }
    if (given.mode == SelfShadow::Mode::soft && !dykhta) self_shadow.softening = given.softening;
}

}  // namespace reliefbench
