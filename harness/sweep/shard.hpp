#pragma once

#include "sweep/cell.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace reliefbench {

/// One of `count` parts of a sweep, which different machines can measure. `index` counts from 1.
struct Shard {
    std::size_t index = 1;
    std::size_t count = 1;

    bool operator==(const Shard&) const = default;
};

/// "2/8"; an Error says what is wrong.
Shard parse_shard(const std::string& text);
std::string to_string(Shard shard);

/// The shard of each cell, from 1 to `count`: whole blocks (make_blocks) of the whole sweep, so that every shard holds
/// whole views where they fit into a block. Blocks are dealt, the dearest first, each to the shard that has least so
/// far; what a block costs is estimated from its cells and the pixels of its views, which is the same on every machine.
/// Skipped cells belong to the first shard. More shards than blocks leave some empty.
std::vector<std::size_t> shards_of_cells(const std::vector<Cell>& cells, std::size_t count);

/// The cells of one shard, in their order.
std::vector<Cell> cells_of_shard(const std::vector<Cell>& cells, Shard shard);

}  // namespace reliefbench
