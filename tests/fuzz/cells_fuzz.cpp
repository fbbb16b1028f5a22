// A cells.jsonl: what is read is what would be written.

#include "core/error.hpp"
#include "fuzz/fuzz_target.hpp"
#include "store/run_folder.hpp"

#include <sstream>
#include <string>

using namespace reliefbench;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
        for (const CellResult& cell : parse_cells(text, "cells.jsonl")) {
            const std::string written = to_json(cell).dump() + '\n';
            std::istringstream written_text(written);
            const std::vector<CellResult> again = parse_cells(written_text, "written");
            fuzz_require(again.size() == 1 && to_json(again.front()).dump() + '\n' == written);
        }
    } catch (const Error&) {
        // Refused, as it may be.
    }
    return 0;
}
