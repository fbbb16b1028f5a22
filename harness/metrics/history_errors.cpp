#include "metrics/history_errors.hpp"

#include "metrics/flip.hpp"
#include "metrics/image_errors.hpp"

#include <cassert>
#include <cmath>
#include <utility>

namespace reliefbench {

namespace {

using Difference = std::array<float, 3>;

/// Of a resolved frame at the pixels that a point lands between.
Difference landed_error(const Landing& landing, const ResolvedFrame& frame) {
    Difference error{};
    for (std::size_t i = 0; i < landing.weights.size(); ++i) {
        const float weight = landing.weights[i];
        if (weight == 0) continue;
        const std::size_t pixel =
            frame.history.index(landing.x + static_cast<int>(i % 2), landing.y + static_cast<int>(i / 2));
        for (std::size_t channel = 0; channel < error.size(); ++channel)
            error[channel] += weight * (frame.history.texels[pixel][channel] - frame.still.texels[pixel][channel]);
    }
    return error;
}

template <auto Figure, auto Member>
std::optional<double> of_history(const HistoryErrors& errors) {
    const std::optional<MotionFigures::Values>& values = errors.*Figure;
    return values ? std::optional((*values).*Member) : std::nullopt;
}

FigureDeclaration history_figure(std::string path, std::string label) {
    return {.path = std::move(path),
            .label = std::move(label),
            .unit = "",
            .better = Better::lower,
            .needs = {std::string(figure_needs::truth), std::string(figure_needs::motion),
                      std::string(figure_needs::lighting), std::string(figure_needs::history)}};
}

const std::vector<FigureOf<HistoryErrors>>& history_table() {
    constexpr auto ghosts = &HistoryErrors::ghosting;
    constexpr auto flip = &HistoryErrors::flip;
    using Values = MotionFigures::Values;
    static const std::vector<FigureOf<HistoryErrors>> table = {
        {in_short(history_figure("motion.ghosting.mean", "Ghosting, mean"), "ghosting",
                  "FLIP of the history against frames of a still camera"),
         of_history<ghosts, &Values::mean>},
        {history_figure("motion.ghosting.p95", "Ghosting, p95"), of_history<ghosts, &Values::p95>},
        {history_figure("motion.ghosting.max", "Ghosting, maximum"), of_history<ghosts, &Values::max>},
        {history_figure("motion.history_flip.mean", "FLIP between frames with history, mean"),
         of_history<flip, &Values::mean>},
        {history_figure("motion.history_flip.p95", "FLIP between frames with history, p95"),
         of_history<flip, &Values::p95>},
        {history_figure("motion.history_flip.max", "FLIP between frames with history, maximum"),
         of_history<flip, &Values::max>},
    };
    return table;
}

}  // namespace

std::vector<double> ghosting(const ResolvedFrame& frame, const Footprint& footprint) {
    const Image<float> map = footprint_flip_map(frame.history, frame.still, footprint);
    std::vector<double> values;
    for (std::size_t pixel = 0; pixel < map.texels.size(); ++pixel) {
        if (footprint.inside.texels[pixel] != 0) values.push_back(map.texels[pixel]);
    }
    return values;
}

std::vector<double> history_flip(const Image<Landing>& landings, const ResolvedFrame& first,
                                 const ResolvedFrame& second) {
    assert(landings.size == first.history.size && landings.size == second.history.size);
    Image<Difference> carried = first.history;
    for (std::size_t pixel = 0; pixel < landings.texels.size(); ++pixel) {
        const Landing& landing = landings.texels[pixel];
        if (!landing.is_seen()) continue;
        const Difference error = landed_error(landing, second);
        for (std::size_t channel = 0; channel < error.size(); ++channel)
            carried.texels[pixel][channel] = first.still.texels[pixel][channel] + error[channel];
    }
    const Image<float> map = flip_map(first.history, carried);
    std::vector<double> values;
    for (std::size_t pixel = 0; pixel < map.texels.size(); ++pixel) {
        if (landings.texels[pixel].is_seen()) values.push_back(map.texels[pixel]);
    }
    return values;
}

std::vector<FigureDeclaration> history_figures() {
    return declarations_in(history_table());
}

FigureValueList figures_of(const HistoryErrors& errors) {
    return values_in(history_table(), errors);
}

}  // namespace reliefbench
