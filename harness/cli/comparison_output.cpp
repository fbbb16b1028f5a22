#include "cli/comparison_output.hpp"

#include "cli/results.hpp"
#include "cli/terminal.hpp"
#include "core/suggest.hpp"
#include "report/comparison_words.hpp"

#include <CLI/CLI.hpp>

namespace reliefbench {

void ComparisonOutput::add_to(CLI::App& command) {
    command.add_option("--format", format, "How to write the result; default: table")
        ->type_name(join(comparison_format_names(), "|"));
    command.add_flag("--all", all, "In the table, list cells that stayed the same and every change of quality, too");
    command.add_flag("--accept-mixed", accept_mixed,
                     "A quality of which some figures are better and others worse is no reason for exit code 1");
}

void ComparisonOutput::check() const {
    parse_comparison_format(format);
}

ExitCode ComparisonOutput::print(Comparison comparison) const {
    comparison.accept_mixed = accept_mixed;
    print_results(format_comparison(comparison, parse_comparison_format(format), {all, table_columns()}));
    return exit_code_of(comparison);
}

ExitCode exit_code_of(const Comparison& comparison) {
    const ComparisonCounts counts = count(comparison);
    const std::size_t undecided = comparison.quality_only ? counts.not_comparable : counts.undecided;
    const std::size_t regressions =
        (comparison.quality_only ? 0 : counts.slower) + counts.worse + (comparison.accept_mixed ? 0 : counts.mixed);
    ExitCode code = ExitCode::done;
    if (undecided > 0 || comparison.cells.empty()) code = worse_of(code, ExitCode::undecided);
    if (regressions > 0) code = worse_of(code, ExitCode::regression);
    if (counts.failed_now > 0) code = worse_of(code, ExitCode::cells_failed);
    return code;
}

}  // namespace reliefbench
