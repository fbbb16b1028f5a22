#include "store/cell_times.hpp"

#include <limits>
#include <utility>

namespace reliefbench {

namespace {

template <typename Value>
std::optional<double> as_number(const Value& value) {
    return static_cast<double>(value);
}
template <typename Value>
std::optional<double> as_number(const std::optional<Value>& value) {
    return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
}

/// Of a file, so that it may be larger than any that was written.
template <typename Value>
void set_number(Value& member, double value) {
    constexpr Value largest = std::numeric_limits<Value>::max();
    member = value < static_cast<double>(largest) ? static_cast<Value>(value) : largest;
}
template <typename Value>
void set_number(std::optional<Value>& member, double value) {
    set_number(member.emplace(), value);
}

/// A figure of a structure, and the member that holds it.
template <typename Fields>
struct FieldFigure {
    FigureDeclaration figure;
    std::optional<double> (*value)(const Fields& fields);
    void (*set)(Fields& fields, double value);
    /// Runs made before others were kept lack them.
    bool is_in_every_version = true;
};

template <typename Fields, auto Member>
FieldFigure<Fields> field_figure(FigureDeclaration figure, bool is_in_every_version = true) {
    return {std::move(figure), [](const Fields& fields) { return as_number(fields.*Member); },
            [](Fields& fields, double value) { set_number(fields.*Member, value); }, is_in_every_version};
}

template <auto Bound>
FieldFigure<PassTiming> bound_figure(FigureDeclaration figure) {
    return {std::move(figure), [](const PassTiming& timing) { return as_number(timing.ci95_ms.*Bound); },
            [](PassTiming& timing, double value) { timing.ci95_ms.*Bound = value; }};
}

FigureDeclaration of_timing(std::string path, std::string label, std::string unit, Better better) {
    return {.path = std::move(path),
            .label = std::move(label),
            .unit = std::move(unit),
            .better = better,
            .needs = {std::string(figure_needs::timing)}};
}

FigureDeclaration count_of_timing(std::string path, std::string label, std::string unit = "") {
    FigureDeclaration figure = of_timing(std::move(path), std::move(label), std::move(unit), Better::neither);
    figure.is_count = true;
    return figure;
}

/// As they are of the draw; the other passes have the same.
const std::vector<FieldFigure<PassTiming>>& pass_table() {
    constexpr Better lower = Better::lower;
    using Pass = PassTiming;
    static const std::vector<FieldFigure<Pass>> table = {
        field_figure<Pass, &Pass::median_ms>(
            in_short(of_timing("time.draw.median_ms", "Draw time", "ms", lower), "ms", "median of the draw")),
        field_figure<Pass, &Pass::mad_ms>(of_timing("time.draw.mad_ms", "Draw time, MAD", "ms", Better::neither)),
        bound_figure<&Interval::low>(of_timing("time.draw.ci95_ms.low", "Draw time, 95 % interval, low", "ms", lower)),
        bound_figure<&Interval::high>(
            of_timing("time.draw.ci95_ms.high", "Draw time, 95 % interval, high", "ms", lower)),
        field_figure<Pass, &Pass::n>(count_of_timing("time.draw.n", "Samples of the draw")),
        field_figure<Pass, &Pass::repeats>(count_of_timing("time.draw.repeats", "Draws per sample")),
        field_figure<Pass, &Pass::rounds>(count_of_timing("time.draw.rounds", "Rounds of the draw"), false),
        field_figure<Pass, &Pass::outliers>(count_of_timing("time.draw.outliers", "Outliers of the draw", "samples"),
                                            false),
        field_figure<Pass, &Pass::lower_quartile_ms>(
            of_timing("time.draw.lower_quartile_ms", "Draw time, lower quartile", "ms", lower), false),
    };
    return table;
}

const std::vector<FieldFigure<CellTimes>>& cell_time_table() {
    constexpr Better lower = Better::lower;
    using Times = CellTimes;
    static const std::vector<FieldFigure<Times>> table = {
        field_figure<Times, &Times::ns_per_pixel>(
            in_short(of_timing("time.ns_per_pixel", "Draw time per covered pixel", "ns", lower), "ns/pixel",
                     "per covered pixel")),
        field_figure<Times, &Times::throttled_rounds>(count_of_timing("time.throttled_rounds", "Throttled rounds")),
        field_figure<Times, &Times::prepare_ms>(
            in_short(of_timing("prepare.ms", "Preparation of maps", "ms", lower), "prep ms", "making its maps")),
        field_figure<Times, &Times::prepare_bytes>(
            {.path = "prepare.bytes", .label = "Memory of maps", .unit = "bytes", .better = lower, .is_count = true}),
    };
    return table;
}

}  // namespace

std::vector<FigureDeclaration> time_figures() {
    std::vector<FigureDeclaration> all;
    for (const FieldFigure<PassTiming>& each : pass_table())
        all.push_back(each.figure);
    for (const FieldFigure<CellTimes>& each : cell_time_table())
        all.push_back(each.figure);
    return all;
}

std::size_t time_figure_count() {
    return pass_table().size() + cell_time_table().size();
}

std::optional<double> pass_value(std::size_t figure, const PassTiming& timing) {
    return figure < pass_table().size() ? pass_table()[figure].value(timing) : std::nullopt;
}

void set_pass_value(std::size_t figure, PassTiming& timing, double value) {
    if (figure < pass_table().size()) pass_table()[figure].set(timing, value);
}

bool is_of_every_pass(std::size_t figure) {
    return figure < pass_table().size() && pass_table()[figure].is_in_every_version;
}

std::optional<double> time_value(std::size_t figure, const CellTimes& times) {
    if (figure >= pass_table().size()) return cell_time_table()[figure - pass_table().size()].value(times);
    const auto draw = times.time.find(draw_pass);
    return draw == times.time.end() ? std::nullopt : pass_value(figure, draw->second);
}

void set_time_value(std::size_t figure, CellTimes& times, double value) {
    cell_time_table()[figure - pass_table().size()].set(times, value);
}

}  // namespace reliefbench
