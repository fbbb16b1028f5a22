#pragma once

#include "core/error.hpp"
#include "core/parallel.hpp"

#include <cerrno>
#include <cstring>
#include <istream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reliefbench {

/// parse(line, where) of every line of `text`, on all cores, in their order. `where` names the line, the first one as
/// number `first`. Every line must end; the first one that is refused is the Error.
template <typename Parse>
auto parse_lines(std::string_view text, const std::string& file, std::size_t first, const Parse& parse) {
    using Parsed = decltype(parse(std::string_view(), std::string()));
    constexpr std::size_t lines_at_a_time = 64;
    const auto where = [&](std::size_t line) { return fmt::format("{} (line {})", file, first + line); };
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string_view::npos) fail("{}: the line is cut short; remove it", where(lines.size()));
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    std::vector<Parsed> parsed(lines.size());
    parallel_for(lines.size(), lines_at_a_time, [&](std::size_t begin, std::size_t end) {
        for (std::size_t line = begin; line < end; ++line)
            parsed[line] = parse(lines[line], where(line));
    });
    return parsed;
}

/// Hands over parse(line, where) of every line of a stream to use(parsed, where), one by one and in their order. Reads
/// some megabytes at a time: the file may be larger than memory.
template <typename Parse, typename Use>
void for_each_parsed_line(std::istream& stream, const std::string& file, const Parse& parse, const Use& use) {
    constexpr std::size_t bytes_at_a_time = std::size_t{8} << 20;
    std::size_t number = 1;
    std::string text;
    for (bool more = true; more;) {
        const std::size_t rest = text.size();
        text.resize(rest + bytes_at_a_time);
        stream.read(text.data() + rest, bytes_at_a_time);
        if (stream.bad()) fail("cannot read {}: {}", file, std::strerror(errno));
        text.resize(rest + static_cast<std::size_t>(stream.gcount()));
        more = !stream.eof();
        // What has no end yet waits for it; at the end of the file it is an Error.
        const std::size_t whole = more ? text.rfind('\n') + 1 : text.size();  // npos + 1 == 0
        for (auto& parsed : parse_lines(std::string_view(text).substr(0, whole), file, number, parse))
            use(std::move(parsed), fmt::format("{} (line {})", file, number++));
        text.erase(0, whole);
    }
}

}  // namespace reliefbench
