#pragma once

#include <CLI/Formatter.hpp>

#include <string>

namespace reliefbench {

/// Writes options as they are typed: without CLI11's own notes of checks (":{plain,force}") and of a flag's value.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
    std::string make_option_opts(const CLI::Option* option) const override;
};

}  // namespace reliefbench
