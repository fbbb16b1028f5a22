#include "cli/figure_choice.hpp"

#include "core/error.hpp"
#include "core/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace reliefbench {

namespace {

/// Of figures that a short name may mean.
constexpr std::size_t max_suggested_figures = 6;

/// In small letters: "error.uv_texels.p99" is error, uv, texels, p99.
std::vector<std::string> words_of_figure(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char character : text) {
        const auto byte = static_cast<unsigned char>(character);
        if (std::isalnum(byte) != 0) {
            words.back() += static_cast<char>(std::tolower(byte));
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

using FigureChoices = std::vector<const FigureDeclaration*>;

/// Of this version and, after them, what a later one declared in a run.
FigureChoices figures_to_choose(std::span<const StoredRun> runs) {
    FigureChoices all;
    for (const FigureDeclaration& figure : figures())
        all.push_back(&figure);
    for (const StoredRun& run : runs) {
        for (const FigureDeclaration& figure : run.run.figures->all()) {
            const bool known = std::any_of(all.begin(), all.end(),
                                           [&](const FigureDeclaration* each) { return each->path == figure.path; });
            if (!known) all.push_back(&figure);
        }
    }
    return all;
}

/// Figures that a short name means: those that tables call so, else those whose path ends so, else those that have all
/// its words in their path or label. Deeper paths first, as what is of a part decides ("image.footprint.flip" before
/// "image.flip").
std::vector<std::string> figures_meant(const std::string& name, const FigureChoices& choices) {
    const std::vector<std::string> words = words_of_figure(name);
    if (words.empty()) return {};
    std::vector<std::string> called;
    std::vector<std::string> ending;
    std::vector<std::string> having;
    for (const FigureDeclaration* figure : choices) {
        if (words_of_figure(figure->short_label) == words) called.push_back(figure->path);
        std::vector<std::string> known = words_of_figure(figure->path);
        if (known.size() >= words.size() &&
            std::equal(words.begin(), words.end(), known.end() - static_cast<std::ptrdiff_t>(words.size()))) {
            ending.push_back(figure->path);
        }
        const std::vector<std::string> label = words_of_figure(figure->label);
        known.insert(known.end(), label.begin(), label.end());
        const bool has_all = std::all_of(words.begin(), words.end(), [&](const std::string& word) {
            return std::find(known.begin(), known.end(), word) != known.end();
        });
        if (has_all) having.push_back(figure->path);
    }
    std::vector<std::string>& meant = !called.empty() ? called : !ending.empty() ? ending : having;
    std::stable_sort(meant.begin(), meant.end(), [](const std::string& a, const std::string& b) {
        return std::count(a.begin(), a.end(), '.') > std::count(b.begin(), b.end(), '.');
    });
    if (meant.size() > max_suggested_figures) {
        meant.resize(max_suggested_figures);
        meant.emplace_back("...");
    }
    return std::move(meant);
}

std::string suggest_figures(const std::string& name, const FigureChoices& choices) {
    const std::vector<std::string> meant = figures_meant(name, choices);
    if (!meant.empty()) return fmt::format(" (did you mean {}?)", join(meant));
    std::vector<std::string> paths;
    for (const FigureDeclaration* each : choices)
        paths.push_back(each->path);
    return did_you_mean(name, paths);
}

}  // namespace

const FigureDeclaration& chosen_figure(const std::string& path, const std::string& option,
                                       std::span<const StoredRun> runs) {
    const FigureChoices choices = figures_to_choose(runs);
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&](const FigureDeclaration* figure) { return figure->path == path; });
    if (found != choices.end()) return **found;
    fail("{}: there is no figure '{}'{}; `reliefbench list figures` has them all", option, path,
         suggest_figures(path, choices));
}

}  // namespace reliefbench
