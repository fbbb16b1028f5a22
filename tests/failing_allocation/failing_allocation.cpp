// A library to be loaded before a program's own (LD_PRELOAD): allocations of exactly as many bytes as
// RELIEFBENCH_REFUSE_ALLOCATIONS_OF says fail, as they do where memory is used up.

#include <cstddef>
#include <cstdlib>

extern "C" {

/// glibc's own malloc, which the one below takes the place of.
void* __libc_malloc(std::size_t size);

void* malloc(std::size_t size) {
    static const char* const refused = std::getenv("RELIEFBENCH_REFUSE_ALLOCATIONS_OF");
    if (refused != nullptr && size == std::strtoull(refused, nullptr, 10)) return nullptr;
    return __libc_malloc(size);
}
}
