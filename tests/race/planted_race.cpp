// A race on purpose: shows that ThreadSanitizer looks into what parallel_for runs. Ends with success where nothing
// looks.

#include "core/parallel.hpp"

#include <cstdio>

int main() {
    constexpr std::size_t count = 100000;
    std::size_t sum = 0;
    reliefbench::parallel_for(count, 1, [&sum](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            sum += i;  // by several threads, with nothing between them
    });
    std::printf("%zu\n", sum);
    return 0;
}
