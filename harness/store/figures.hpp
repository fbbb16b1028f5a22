#pragma once

#include "core/figure.hpp"
#include "core/json.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace reliefbench {

/// What the device measures anew each time, unlike the others, which repeat exactly on it.
bool is_time(const FigureDeclaration& figure);

/// Of how far a picture is from the truth, alone or in motion.
bool is_error(const FigureDeclaration& figure);

/// Members of a line of cells.jsonl that hold no figures, those of every version.
const std::vector<std::string>& keys_beside_figures();

/// Figures by path, as they nest in a line of cells.jsonl. Does not change, so that pointers into it stay good.
class FigureList {
public:
    /// A member of a line: a figure, or a group of members.
    struct Member {
        std::string key;
        /// Where in the list; empty for a group.
        std::optional<std::size_t> figure = {};
        std::vector<Member> members = {};

        /// Written as an array of two.
        bool is_interval() const { return members.size() == 2 && members[0].key == "low" && members[1].key == "high"; }
        /// Null where there is none.
        const Member* find(std::string_view member) const;
    };

    /// Two of one path, or one whose path leads through another, are an Error.
    explicit FigureList(std::vector<FigureDeclaration> figures);
    FigureList(const FigureList&) = delete;
    FigureList& operator=(const FigureList&) = delete;

    std::span<const FigureDeclaration> all() const { return figures_; }
    /// Null where there is none of that path.
    const FigureDeclaration* find(std::string_view path) const;
    /// Of this list's figure of the same path; empty where it has none.
    std::optional<std::size_t> index_of(const FigureDeclaration& figure) const;
    /// Groups of a line, in the order of their first figures.
    const Member& line() const { return line_; }

private:
    std::vector<FigureDeclaration> figures_;
    std::unordered_map<std::string_view, std::size_t> index_by_path_;
    Member line_;
};

/// Every number that any cell may have, in the order of the file. Left out is what is named by techniques and drivers:
/// the times of preparation passes, `pipeline` and `executable`.
std::shared_ptr<const FigureList> declared_figures();
std::span<const FigureDeclaration> figures();
/// Among them; null where there is none of that path.
const FigureDeclaration* find_figure(std::string_view path);
/// The same, of a path that is chosen as a default: it is declared.
const FigureDeclaration& known_figure(std::string_view path);

/// `[{"path", "label", "unit", "better": "lower"|"higher"|"neither", "needs": [...]}, ...]`, with `count`, `over`,
/// `infinite_at_zero`, `stand_in`, `percent_of_pixels`, `short_label` and `legend` where there is something to say.
Json figures_to_json(std::span<const FigureDeclaration> list = figures());

/// Those of this program and, after them, those that a later version declared in `figures` of its run.json; `record` is
/// run.json as a whole. Errors name `file` and the JSON path.
std::shared_ptr<const FigureList> figures_of_record(const Json& record, const std::string& file);

}  // namespace reliefbench
