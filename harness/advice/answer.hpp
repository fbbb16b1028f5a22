#pragma once

#include "report/advice.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace reliefbench {

/// What advice from a narrowed sweep has to say beside the advice itself.
struct NarrowedSweep {
    /// What was measured, or left out with a reason.
    const std::vector<CellResult>& cells;
    /// Of the whole configuration.
    std::size_t cells_total = 0;
    /// The time ended before everything was decided.
    bool is_time_over = false;
    /// What presets are called, by name.
    std::map<std::string, std::string> preset_titles = {};
};

/// In words, for the terminal: what to use, as a line for a configuration too; the next better step and its price; what
/// the nearest preset gives; what cannot be told apart; first for all kinds of view together, then one by one. Then
/// what was left out and why. `columns`: the widest line, but of lines that are to be pasted.
std::string answer_words(const Advice& advice, const NarrowedSweep& sweep, std::size_t columns);

/// The advice with "cells": how many were measured, how many of them with few rounds, how many were left out.
Json answer_json(const Advice& advice, const NarrowedSweep& sweep);

}  // namespace reliefbench
