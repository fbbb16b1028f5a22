#include "report/table.hpp"

#include "core/counted.hpp"
#include "core/suggest.hpp"
#include "report/cautions.hpp"
#include "report/quality_cost.hpp"
#include "report/text_layout.hpp"
#include "store/chosen_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <vector>

namespace reliefbench {

namespace {

/// Mark and a space.
constexpr std::size_t mark_columns = 2;
/// Room for names that columns give way to.
constexpr std::size_t wanted_name_columns = 28;
constexpr std::size_t variant_indent = 2;
/// Cells named under each reason for which cells failed or were skipped.
constexpr std::size_t unmeasured_cells_named = 3;

/// Columns that give way, the first first.
constexpr std::array<std::string_view, 6> dispensable = {chosen_figures::depth,       chosen_figures::ns_per_pixel,
                                                         chosen_figures::preparation, chosen_figures::median_uv,
                                                         chosen_figures::taps,        chosen_figures::shadow_taps};

constexpr std::string_view bold = "\033[1m";
constexpr std::string_view cyan = "\033[36m";
constexpr std::string_view yellow = "\033[33m";
constexpr std::string_view plain = "\033[0m";

constexpr const char* colour_legend = "in each view and column: {}best third{}, {}worst third{}\n";

/// Colours by rank among the rows of a view and variant, "" for the middle. Errors of rows marked '!' do not count.
class Ranks {
public:
    Ranks(const QualityCostView& view, const std::vector<QualityCostColumn>& columns) : columns_(columns) {
        for (const QualityCostRow& row : view.rows) {
            std::vector<std::vector<double>>& values = values_[row.variant];
            values.resize(columns.size());
            for (std::size_t column = 0; column < columns.size(); ++column) {
                if (counts(row, column)) values[column].push_back(*row.figures[column].value);
            }
        }
    }

    std::string_view colour(const QualityCostRow& row, std::size_t column) const {
        if (!counts(row, column)) return "";
        const double value = *row.figures[column].value;
        const std::vector<double>& all = values_.at(row.variant)[column];
        const Better direction = columns_[column].figure->better;
        const auto better =
            std::count_if(all.begin(), all.end(), [&](double other) { return is_better(other, value, direction); });
        const auto worse =
            std::count_if(all.begin(), all.end(), [&](double other) { return is_better(value, other, direction); });
        if (2 * better < worse) return cyan;
        if (2 * worse < better) return yellow;
        return "";
    }

private:
    bool counts(const QualityCostRow& row, std::size_t column) const {
        return row.figures[column].value && !(is_error(*columns_[column].figure) && row.mark == '!');
    }

    const std::vector<QualityCostColumn>& columns_;
    /// By variant and column.
    std::map<std::string, std::vector<std::vector<double>>> values_;
};

/// Of a row's name: the setting, or below it the variant.
std::size_t name_columns(const QualityCostRow& row) {
    return row.variant.empty() ? text_width(row.setting) : variant_indent + text_width(row.variant);
}

/// One layout for all views, so that columns can be compared from view to view.
class Layout {
public:
    Layout(const QualityCostTable& table, const TableStyle& style) : table_(table), style_(style) {
        std::size_t longest_name = 0;
        for (const QualityCostColumn& column : table.columns) {
            widths_.push_back(text_width(column.title));
            shown_.push_back(true);
        }
        for (const QualityCostView& view : table.views) {
            for (const QualityCostRow& row : view.rows) {
                longest_name = std::max(longest_name, name_columns(row));
                for (std::size_t column = 0; column < widths_.size(); ++column) {
                    widths_[column] = std::max(widths_[column], text_width(row.figures[column].text));
                }
            }
        }
        for (const std::string_view path : dispensable) {
            if (taken() + std::min(longest_name, wanted_name_columns) <= style.columns) break;
            for (std::size_t column = 0; column < shown_.size(); ++column) {
                if (table.columns[column].figure->path == path) shown_[column] = false;
            }
        }
        name_width_ = std::min(longest_name, style.columns - std::min(style.columns, taken()));
    }

    /// What stands above the variants of a setting; "" where there is one row of it alone.
    std::string setting_lines(const QualityCostRow& row) const {
        return row.variant.empty() ? "" : indented(row.setting, mark_columns, style_.columns);
    }

    std::string titles_line() const {
        std::string text(mark_columns + name_width_, ' ');
        for (std::size_t column = 0; column < widths_.size(); ++column) {
            if (!shown_[column]) continue;
            text += std::string(space_between, ' ') + pad_left(table_.columns[column].title, widths_[column]);
        }
        return text + '\n';
    }

    std::string row_lines(const QualityCostRow& row, const Ranks& ranks) const {
        const std::size_t indent = row.variant.empty() ? 0 : variant_indent;
        const std::vector<std::string> name =
            wrap(row.variant.empty() ? row.setting : row.variant, name_width_ - std::min(indent, name_width_));
        std::string text = coloured(std::string(1, row.mark), row.mark == ' ' ? "" : bold) + ' ' +
                           pad_right(std::string(indent, ' ') + name.front(), name_width_);
        for (std::size_t column = 0; column < widths_.size(); ++column) {
            if (!shown_[column]) continue;
            text += std::string(space_between, ' ') +
                    coloured(pad_left(row.figures[column].text, widths_[column]), ranks.colour(row, column));
        }
        text += '\n';
        for (std::size_t rest = 1; rest < name.size(); ++rest) {
            text += std::string(mark_columns + indent, ' ') + name[rest] + '\n';
        }
        return text;
    }

private:
    /// Columns of everything but the name.
    std::size_t taken() const {
        std::size_t columns = mark_columns;
        for (std::size_t column = 0; column < widths_.size(); ++column) {
            if (shown_[column]) columns += space_between + widths_[column];
        }
        return columns;
    }

    std::string coloured(const std::string& text, std::string_view colour) const {
        if (!style_.colour || colour.empty()) return text;
        return fmt::format("{}{}{}", colour, text, plain);
    }

    const QualityCostTable& table_;
    const TableStyle& style_;
    std::vector<std::size_t> widths_;
    std::vector<bool> shown_;
    std::size_t name_width_ = 0;
};

/// Entries of a legend, none broken but one that is wider than a line.
std::string in_lines(const std::vector<std::string>& entries, std::size_t columns) {
    constexpr std::string_view between = "; ";
    std::string text;
    std::string line;
    for (const std::string& entry : entries) {
        if (!line.empty() && text_width(line + entry) + between.size() >= columns) {
            text += indented(line + ';', 0, columns);
            line.clear();
        }
        line += line.empty() ? entry : std::string(between) + entry;
    }
    return text + indented(line, 0, columns);
}

/// Cells of one status by their reasons.
std::string format_reasons(const std::vector<CellResult>& cells, CellStatus status, std::string_view word,
                           std::size_t columns) {
    std::string text;
    for (const auto& [reason, of_reason] : group_by_reason(cells, status)) {
        text += indented(fmt::format("{}, {}: {}", word, counted(of_reason.size(), "cell"), reason), 0, columns);
        for (std::size_t cell = 0; cell < std::min(of_reason.size(), unmeasured_cells_named); ++cell) {
            text += indented(of_reason[cell]->cell, 4, columns);
        }
        if (of_reason.size() > unmeasured_cells_named)
            text += indented(fmt::format("and {} more", of_reason.size() - unmeasured_cells_named), 4, columns);
    }
    return text;
}

}  // namespace

std::string format_table(const std::vector<CellResult>& cells, const TableStyle& style, const Json& record) {
    const QualityCostTable table = quality_cost_table(cells, record);
    const Layout layout(table, style);
    std::string text;
    for (const QualityCostView& view : table.views) {
        const Ranks ranks(view, table.columns);
        text += indented(view.view, 0, style.columns) + layout.titles_line();
        std::string setting;
        for (const QualityCostRow& row : view.rows) {
            if (row.setting != setting) text += layout.setting_lines(row);
            setting = row.setting;
            text += layout.row_lines(row, ranks);
        }
        text += '\n';
    }
    if (!table.views.empty()) {
        text += join(table.mark_legend, "\n") + '\n' + in_lines(table.legend, style.columns);
        if (table.flip != RankingFlip::footprint) text += indented(caveat_of(table.flip), 0, style.columns);
        if (style.colour) text += fmt::format(colour_legend, cyan, plain, yellow, plain);
        for (const std::string& caution : cautions(cells, record))
            text += indented("caution: " + caution, 0, style.columns);
    }
    const std::string reasons = format_reasons(cells, CellStatus::failed, "failed", style.columns) +
                                format_reasons(cells, CellStatus::skipped, "skipped", style.columns);
    if (!text.empty() && !reasons.empty()) text += '\n';
    return text + reasons;
}

}  // namespace reliefbench
