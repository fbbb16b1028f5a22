// Calls a fuzz target with the content of every file in the folders named: what was found once stays found, also where
// there is no libFuzzer.

#include "core/file.hpp"
#include "fuzz/fuzz_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <vector>

int main(int argc, char** argv) {
    std::vector<std::filesystem::path> files;
    for (int folder = 1; folder < argc; ++folder) {
        for (const auto& entry : std::filesystem::directory_iterator(argv[folder]))
            files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files) {
        fmt::print(stderr, "{}\n", file.string());
        const std::string bytes = reliefbench::read_text_file(file);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    fmt::print("{} inputs\n", files.size());
    return files.empty() ? 1 : 0;
}
