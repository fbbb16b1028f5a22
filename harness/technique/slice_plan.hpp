#pragma once

#include <cstdint>
#include <deque>

namespace reliefbench {

/// What one dispatch does of a pass in slices, texels searched (numbered row by row) or rows written: [begin, end).
struct Slice {
    std::int64_t begin = 0;
    std::int64_t end = 0;
};

/// Cuts a pass over so many sources, each of which costs so many invocations so many loop iterations at most, into
/// dispatches of about a tenth of a second, none of which costs an invocation more iterations than every device lets it
/// have. Pure: times come from outside.
class SlicePlan {
public:
    SlicePlan(std::int64_t sources, std::int64_t invocations, int iterations);

    bool is_done() const { return done_ == sources_; }
    /// The next one, for which `took` must be called before another is asked for.
    Slice next() const;
    void took(double milliseconds);

    /// How many have been timed.
    int slices() const { return slices_; }
    /// Of the whole search in [0, 1].
    double fraction() const { return static_cast<double>(done_) / static_cast<double>(sources_); }
    double elapsed_ms() const { return elapsed_ms_; }
    /// Of the whole search, if the rest costs as much a source as slices lately did while nothing else kept the device:
    /// the lower quartile of the last ones of full length, for load only ever makes a slice longer, and short ones
    /// mostly tell what a dispatch costs. Where none was of full length, as the last one; 0 before the first.
    double estimated_ms() const;
    /// Whether enough slices of full length have been timed that the estimate means something.
    bool is_estimate_sound() const;

private:
    std::int64_t sources_;
    std::int64_t most_;
    std::int64_t length_;
    std::int64_t done_ = 0;
    int slices_ = 0;
    double elapsed_ms_ = 0;
    double last_ms_per_source_ = 0;
    /// Of slices of full length, the last ones.
    std::deque<double> full_ms_per_source_;
};

}  // namespace reliefbench
