#include "core/figure.hpp"

#include <algorithm>
#include <utility>

namespace reliefbench {

std::string_view to_string(Better better) {
    switch (better) {
        case Better::lower:
            return "lower";
        case Better::higher:
            return "higher";
        case Better::neither:
            return "neither";
    }
    return "";
}

bool is_better(double value, double other, Better better) {
    switch (better) {
        case Better::lower:
            return value < other;
        case Better::higher:
            return value > other;
        case Better::neither:
            return false;
    }
    return false;
}

bool FigureDeclaration::has_need(std::string_view need) const {
    return std::find(needs.begin(), needs.end(), need) != needs.end();
}

FigureDeclaration at_percentile(double percent, FigureDeclaration figure) {
    figure.percent_of_pixels = percent;
    return figure;
}

FigureDeclaration in_short(FigureDeclaration figure, std::string short_label, std::string legend) {
    figure.short_label = std::move(short_label);
    figure.legend = std::move(legend);
    return figure;
}

}  // namespace reliefbench
