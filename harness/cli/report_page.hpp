#pragma once

#include <string>

namespace reliefbench {

/// report_page.html as report_page/ builds it: of RELIEFBENCH_DATA_DIR; where that is not set, beside this binary or in
/// the folder above (an unpacked archive). An Error says how to get it.
std::string read_report_page();

}  // namespace reliefbench
