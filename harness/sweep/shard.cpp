#include "sweep/shard.hpp"

#include "core/error.hpp"
#include "core/hash.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <optional>
#include <tuple>

namespace reliefbench {

namespace {

/// What takes as long as the part of a cell that does not depend on its pixels, about a second: comparing so many
/// pixels with the truth, and drawing them, and tracing a truth of so many.
constexpr double compared_pixels = 2e6;
constexpr double traced_pixels = 4e6;

std::optional<std::size_t> parse_count(std::string_view text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

double pixels_of(const ViewKey& view) {
    return static_cast<double>(view.view.resolution.pixels());
}

/// In seconds, roughly.
double cost_of(const Block& block, const std::vector<Cell>& cells) {
    double cost = 0;
    for (std::size_t place = 0; place < block.cells.size(); ++place) {
        const ViewKey& view = cells[block.cells[place]].view;
        const bool same_view = place > 0 && cells[block.cells[place - 1]].view == view;
        cost += 1 + pixels_of(view) / compared_pixels + (same_view ? 0 : pixels_of(view) / traced_pixels);
    }
    return cost;
}

/// The shard of each block, from 0: the longest first to the one that has least (Graham 1969). Blocks that seem to cost
/// the same come in an order that follows no axis, else one shard would get every grazing view.
std::vector<std::size_t> deal(const std::vector<Block>& blocks, const std::vector<Cell>& cells, std::size_t shards) {
    struct Place {
        double cost = 0;
        std::string hash;
        std::size_t block = 0;
    };
    std::vector<Place> order;
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        order.push_back({cost_of(blocks[block], cells), content_hash(cells[blocks[block].cells.front()].id), block});
    }
    std::ranges::sort(order, [](const Place& a, const Place& b) {
        return std::tie(b.cost, a.hash, a.block) < std::tie(a.cost, b.hash, b.block);
    });
    std::vector<double> loads(shards, 0.0);
    std::vector<std::size_t> dealt(blocks.size());
    for (const Place& place : order) {
        const auto least = std::ranges::min_element(loads);
        *least += place.cost;
        dealt[place.block] = static_cast<std::size_t>(least - loads.begin());
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

std::vector<std::size_t> shards_of_cells(const std::vector<Cell>& cells, std::size_t count) {
    assert(count > 0);
    const std::vector<Block> blocks = make_blocks(cells);
    const std::vector<std::size_t> dealt = deal(blocks, cells, count);
    std::vector<std::size_t> shards(cells.size(), 1);
    for (std::size_t block = 0; block < blocks.size(); ++block) {
        for (const std::size_t cell : blocks[block].cells)
            shards[cell] = dealt[block] + 1;
    }
    return shards;
}

std::vector<Cell> cells_of_shard(const std::vector<Cell>& cells, Shard shard) {
    assert(shard.index >= 1 && shard.index <= shard.count);
    const std::vector<std::size_t> shards = shards_of_cells(cells, shard.count);
    std::vector<Cell> kept;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        if (shards[cell] == shard.index) kept.push_back(cells[cell]);
    }
    return kept;
}

}  // namespace reliefbench
