// A race on purpose: shows that ThreadSanitizer looks into what parallel_for runs. Ends with success where nothing
// looks.

#include "core/parallel.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

int main() {
    constexpr std::size_t threads = 2;
    std::atomic<std::size_t> arrived{0};
    std::size_t sum = 0;
    // Where one thread could be done before the other begins, the queue of ranges would order their additions, and of
    // two at the very same moment ThreadSanitizer may miss both. So each waits for the other first (relaxed, which
    // orders nothing; with one core there is one thread only, and an end), and then they take turns.
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    reliefbench::parallel_for(threads, 1, [&](std::size_t begin, std::size_t) {
        arrived.fetch_add(1, std::memory_order_relaxed);
        while (arrived.load(std::memory_order_relaxed) < threads && std::chrono::steady_clock::now() < give_up)
            std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::milliseconds(10 * begin));
        sum += begin + 1;  // by both threads, with nothing between them
    });
    std::printf("%zu\n", sum);
    return 0;
}
