#include "compare/describe.hpp"

#include <fmt/format.h>

#include <cmath>

namespace reliefbench {

namespace {

constexpr std::string_view minus = "\u2212";

/// Three digits are more than any of these numbers is known by; without a sign.
std::string magnitude(double fraction) {
    const double value = 100 * std::abs(fraction);
    return value < 9.95 ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

std::string signed_magnitude(double fraction) {
    return fmt::format("{}{}", fraction < 0 ? minus : "+", magnitude(fraction));
}

std::string evidence_text(std::size_t count, std::string_view unit) {
    if (unit == "runs") return count == 1 ? "1 run a side" : fmt::format("{} runs a side", count);
    return count == 1 ? "1 round" : fmt::format("{} {}", count, unit);
}

std::string more_text(std::size_t count, std::string_view unit) {
    if (unit == "runs") return fmt::format("about {} more {} a side would decide", count, count == 1 ? "run" : "runs");
    return fmt::format("about {} more {} would decide", count, count == 1 ? "round" : unit);
}

std::string undecided_text(const RatioEstimate& estimate, std::string_view unit) {
    if (!std::isfinite(estimate.ci95.high)) {
        return fmt::format("undecided: {} tell nothing yet", evidence_text(estimate.units, unit));
    }
    std::string text = fmt::format("undecided: {} % ({} to {} %), {}; changes above {} would have been seen",
                                   signed_magnitude(estimate.ratio - 1), signed_magnitude(estimate.ci95.low - 1),
                                   signed_magnitude(estimate.ci95.high - 1), evidence_text(estimate.units, unit),
                                   percent(estimate.visible));
    if (!estimate.more) {
        text += fmt::format("; the change is so near the threshold that no reasonable number of {} would decide", unit);
    } else if (*estimate.more > 0) {
        text += "; " + more_text(*estimate.more, unit);
    }
    return text;
}

}  // namespace

std::string percent(double fraction) {
    return magnitude(fraction) + " %";
}

std::string signed_percent(double fraction) {
    return signed_magnitude(fraction) + " %";
}

std::string describe(const RatioEstimate& estimate, Verdict verdict, std::string_view unit) {
    const std::string evidence = evidence_text(estimate.units, unit);
    switch (verdict) {
        case Verdict::slower:
            return fmt::format("slower by {} (95 %: {} to {}), {}", percent(estimate.ratio - 1),
                               magnitude(estimate.ci95.low - 1), percent(estimate.ci95.high - 1), evidence);
        case Verdict::faster:
            return fmt::format("faster by {} (95 %: {} to {}), {}", percent(1 - estimate.ratio),
                               magnitude(1 - estimate.ci95.high), percent(1 - estimate.ci95.low), evidence);
        case Verdict::same:
            return fmt::format("same: {} ({} to {}), {}", signed_percent(estimate.ratio - 1),
                               signed_magnitude(estimate.ci95.low - 1), signed_percent(estimate.ci95.high - 1),
                               evidence);
        case Verdict::undecided:
            return undecided_text(estimate, unit);
    }
    return "";
}

}  // namespace reliefbench
