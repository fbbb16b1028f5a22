#pragma once

#include "core/json.hpp"
#include "store/cell_times.hpp"
#include "store/figure_values.hpp"
#include "sweep/cell.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace reliefbench {

enum class CellStatus { ok, skipped, failed };

std::string_view to_string(StopReason reason);

/// One line of cells.jsonl as plain data; docs/architecture.md lists the fields. What is undefined is empty here and
/// null in the file; non-finite numbers are never written.
struct CellResult : CellTimes {
    CellResult() = default;
    explicit CellResult(std::shared_ptr<const FigureList> list) : figures(std::move(list)) {}

    std::string cell;
    std::string technique;
    /// Of the technique (Cell::preset); empty without one.
    std::string preset;
    Json axes;
    Json parameters;
    CellStatus status = CellStatus::ok;
    std::string reason;

    std::map<std::string, std::uint64_t> pipeline;
    /// What the driver says of the compiled stages, by stage and statistic: registers, spills, bytes of code. Empty
    /// where it says nothing.
    std::map<std::string, std::map<std::string, double>> executable;
    /// All but those of CellTimes.
    FigureValues figures;

    /// Finished by a run that was resumed though its environment had changed (`--resume=force`).
    bool forced_resume = false;
};

/// Empty where the cell has none. Infinite for the PSNR of an image without an error, which is null in the file.
std::optional<double> value_of(const FigureDeclaration& figure, const CellResult& cell);
/// Of a figure that is declared.
std::optional<double> value_of(std::string_view path, const CellResult& cell);
/// Whether the cell has the figure, be it undefined.
bool is_given(const FigureDeclaration& figure, const CellResult& cell);

Json to_json(const CellResult& result);
/// Strict; errors name `file` and the JSON path. A key that is neither of the format nor of the list is one.
CellResult parse_cell_result(const Json& json, const std::string& file,
                             const std::shared_ptr<const FigureList>& list = declared_figures());

}  // namespace reliefbench
