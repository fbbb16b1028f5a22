#pragma once

#include <cstddef>

namespace reliefbench {

/// How wide a table on standard output may be: a terminal's width up to `widest_table`, which pipes and files get.
std::size_t table_columns();

}  // namespace reliefbench
