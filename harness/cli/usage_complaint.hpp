#pragma once

#include <string>

/// Only forward: CLI11 costs seconds per file.
namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace reliefbench {

/// What is wrong with a command line that `app` could not parse, and which help to see, in place of CLI11's own words:
/// those do not say that a word was taken for no command, reverse what was not expected, and make no suggestions.
std::string usage_complaint(const CLI::App& app, const CLI::ParseError& error);

}  // namespace reliefbench
