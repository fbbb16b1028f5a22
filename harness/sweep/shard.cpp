#include "sweep/shard.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <functional>
#include <numeric>
#include <optional>

namespace reliefbench {

namespace {

/// How many pixels of a truth take as long as sampling one cell: a cell's samples take about a second, and a second
/// traces some millions of rays.
constexpr double pixels_per_cell = 4e6;

std::optional<std::size_t> parse_count(std::string_view text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

double pixels_of(const ViewKey& view) {
    return static_cast<double>(view.view.resolution.pixels());
}

/// In cells.
double cost_of(const Block& block, const std::vector<Cell>& cells) {
    double cost = 0;
    for (std::size_t place = 0; place < block.cells.size(); ++place) {
        const ViewKey& view = cells[block.cells[place]].view;
        const bool same_view = place > 0 && cells[block.cells[place - 1]].view == view;
        cost += 1 + (same_view ? 0 : pixels_of(view) / pixels_per_cell);
    }
    return cost;
}

/// The shard of each block, from 0: the longest first to the one that has least (Graham 1969), ties to the first.
std::vector<std::size_t> deal(const std::vector<double>& costs, std::size_t shards) {
    std::vector<std::size_t> order(costs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t block) { return costs[block]; });
    std::vector<double> loads(shards, 0.0);
    std::vector<std::size_t> dealt(costs.size());
    for (const std::size_t block : order) {
        const auto least = std::ranges::min_element(loads);
        *least += costs[block];
        dealt[block] = static_cast<std::size_t>(least - loads.begin());
    }
    return dealt;
}

}  // namespace

Shard parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto index = parse_count(std::string_view(text).substr(0, slash));
    const auto count =
        slash == std::string::npos ? std::nullopt : parse_count(std::string_view(text).substr(slash + 1));
    if (!index || !count || *index < 1 || *index > *count) {
        fail("'{}' is no shard; expected I/N with I from 1 to N, as in 2/8", text);
    }
    return {*index, *count};
}

std::string to_string(Shard shard) {
    return fmt::format("{}/{}", shard.index, shard.count);
}

std::vector<Cell> cells_of_shard(const std::vector<Cell>& cells, Shard shard) {
    assert(shard.index >= 1 && shard.index <= shard.count);
    const std::vector<Block> blocks = make_blocks(cells);
    std::vector<double> costs;
    for (const Block& block : blocks)
        costs.push_back(cost_of(block, cells));
    const std::vector<std::size_t> dealt = deal(costs, shard.count);
    std::vector<std::size_t> shard_of_cell(cells.size(), 0);
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        for (const std::size_t cell : blocks[block].cells)
            shard_of_cell[cell] = dealt[block];
    }
    std::vector<Cell> kept;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        if (shard_of_cell[cell] == shard.index - 1) kept.push_back(cells[cell]);
    }
    return kept;
}

}  // namespace reliefbench
