#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>

/// What libFuzzer calls with bytes of its making, and replay.cpp with those of files. An Error is an answer; any other
/// exception, a crash and a sanitizer's complaint are findings.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace reliefbench {

/// In every build: what does not hold is a finding.
inline void fuzz_require(bool holds) {
    if (!holds) std::abort();
}

}  // namespace reliefbench
