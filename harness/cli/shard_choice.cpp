#include "cli/shard_choice.hpp"

#include "core/counted.hpp"
#include "core/error.hpp"
#include "core/log.hpp"

#include <algorithm>
#include <cstdlib>

namespace reliefbench {

namespace {

std::optional<std::int64_t> number_in(const char* variable) {
    const char* text = std::getenv(variable);
    if (text == nullptr || *text == '\0') return std::nullopt;
    char* end = nullptr;
    const long long value = std::strtoll(text, &end, 10);
    if (*end != '\0') fail("{} is '{}'; expected a whole number", variable, text);
    return value;
}

/// The shard of a task whose number counts from `first`; empty unless both variables are set.
std::optional<Shard> shard_of_task(const char* number, std::int64_t first, const char* count) {
    const std::optional<std::int64_t> task = number_in(number);
    const std::optional<std::int64_t> tasks = number_in(count);
    if (!task || !tasks) return std::nullopt;
    const std::int64_t index = *task - first + 1;
    if (index < 1 || index > *tasks) {
        fail("{} is {}, but {} has {} from {} on; number them without gaps, or name the shard with --shard", number,
             *task, count, counted(static_cast<std::size_t>(std::max<std::int64_t>(*tasks, 0)), "task"), first);
    }
    return Shard{static_cast<std::size_t>(index), static_cast<std::size_t>(*tasks)};
}

}  // namespace

std::optional<Shard> chosen_shard(const std::string& option, const std::optional<Shard>& recorded) {
    if (!option.empty()) return parse_shard(option);
    if (recorded) return recorded;
    const std::int64_t first_task = number_in("SLURM_ARRAY_TASK_MIN").value_or(0);
    if (auto shard = shard_of_task("SLURM_ARRAY_TASK_ID", first_task, "SLURM_ARRAY_TASK_COUNT")) return shard;
    return shard_of_task("GTEST_SHARD_INDEX", 0, "GTEST_TOTAL_SHARDS");
}

std::vector<Cell> take_shard(const std::vector<Cell>& cells, Shard shard) {
    std::vector<Cell> taken = cells_of_shard(cells, shard);
    if (make_blocks(taken).empty()) {
        const std::size_t blocks = make_blocks(cells).size();
        log_warning("shard {} measures nothing: there {} only {} to deal to {}; take fewer shards", to_string(shard),
                    blocks == 1 ? "is" : "are", counted(blocks, "block"), counted(shard.count, "shard"));
    }
    return taken;
}

}  // namespace reliefbench
