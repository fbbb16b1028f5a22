#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace reliefbench {

namespace {

/// Hands out ranges in ascending order. No range is handed out after one has failed; since every lower one has been
/// handed out by then and is finished, the lowest failing range does not depend on scheduling.
class RangeQueue {
public:
    RangeQueue(std::size_t count, std::size_t grain, const std::function<void(std::size_t, std::size_t)>& body)
        : count_(count), grain_(grain), ranges_(count / grain + (count % grain == 0 ? 0 : 1)), body_(body) {}

    std::size_t ranges() const { return ranges_; }

    void work() {
        while (!failed_.load()) {
            const std::size_t range = next_.fetch_add(1);
            if (range >= ranges_) return;
            try {
                body_(range * grain_, std::min(count_, (range + 1) * grain_));
            } catch (...) {
                record_failure(range, std::current_exception());
            }
        }
    }

    void rethrow_failure() const {
        if (failure_) std::rethrow_exception(failure_);
    }

private:
    void record_failure(std::size_t range, std::exception_ptr failure) {
        const std::lock_guard lock(mutex_);
        failed_.store(true);
        if (!failure_ || range < failed_range_) {
            failed_range_ = range;
            failure_ = std::move(failure);
        }
    }

    std::size_t count_;
    std::size_t grain_;
    std::size_t ranges_;
    const std::function<void(std::size_t, std::size_t)>& body_;
    std::atomic<std::size_t> next_{0};
    std::atomic<bool> failed_{false};
    std::mutex mutex_;
    std::size_t failed_range_ = 0;
    std::exception_ptr failure_;
};

}  // namespace

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body) {
    assert(grain > 0);
    RangeQueue queue(count, grain, body);
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t helpers = std::min(cores, std::max<std::size_t>(1, queue.ranges())) - 1;
    {
        std::vector<std::jthread> threads;
        threads.reserve(helpers);
        for (std::size_t helper = 0; helper < helpers; ++helper) {
            threads.emplace_back([&queue] { queue.work(); });
        }
        queue.work();
    }
    queue.rethrow_failure();
}

}  // namespace reliefbench
