#include "cli/figure_choice.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"

#include <vector>

namespace reliefbench {

const FigureDeclaration& chosen_figure(const std::string& path, const std::string& option) {
    if (const FigureDeclaration* const figure = find_figure(path)) return *figure;
    std::vector<std::string> paths;
    for (const FigureDeclaration& each : figures()) {
        paths.emplace_back(each.path);
    }
    fail("{}: there is no figure '{}'{}; `reliefbench list figures` has them all", option, path,
         did_you_mean(path, paths));
}

}  // namespace reliefbench
