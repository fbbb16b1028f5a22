// A cells.jsonl: what is read is what would be written.

#include "core/error.hpp"
#include "fuzz/fuzz_target.hpp"
#include "store/run_folder.hpp"

#include <string_view>

using namespace reliefbench;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const std::string_view text(reinterpret_cast<const char*>(data), size);
        for (const CellResult& cell : parse_cells(text, "cells.jsonl")) {
            const std::string written = to_json(cell).dump() + '\n';
            const std::vector<CellResult> again = parse_cells(written, "written");
            fuzz_require(again.size() == 1 && to_json(again.front()).dump() + '\n' == written);
        }
    } catch (const Error&) {
        // Refused, as it may be.
    }
    return 0;
}
