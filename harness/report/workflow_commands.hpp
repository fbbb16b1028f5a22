#pragma once

#include "compare/comparison.hpp"

#include <string>
#include <string_view>

namespace reliefbench {

enum class Annotation { error, warning, notice };

/// One line of GitHub Actions' workflow commands: "::error title=...::message". What would end a property or the line
/// is escaped as GitHub's runner undoes it (actions/toolkit, packages/core/src/command.ts).
std::string workflow_command(Annotation annotation, std::string_view title, std::string_view message);

/// Annotations of a workflow's run: an error for each cell that is slower, worse or failed now, or of mixed quality (a
/// warning where that is accepted), a warning for each undecided one and for what could not be compared, notices for
/// the summary, the notes and the better news. GitHub shows ten of each kind per step: where there are more, the tenth
/// says how many and names them.
std::string format_workflow_commands(const Comparison& comparison);

}  // namespace reliefbench
