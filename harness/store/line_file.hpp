#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace reliefbench {

/// A file of whole lines that only grows. Every append is handed to the system at once, so that lines outlive the
/// process; one that fails is an Error and is taken back, so that no reader ever sees half a line. A file that was
/// removed meanwhile is an Error, too: what is written to it nobody would find. One process at a time writes to it: a
/// second one gets an Error, unless the first ends within two seconds (one that was killed takes a moment).
class LineFile {
public:
    enum class Start {
        /// Creates the file; one that exists already is an Error.
        created,
        /// Goes on after what is there, whole lines only: a last line that was cut short is taken out. A file that is
        /// missing is created.
        continued,
    };
    LineFile(const std::filesystem::path& path, Start start);
    ~LineFile();
    LineFile(const LineFile&) = delete;
    LineFile& operator=(const LineFile&) = delete;

    /// `line` without its end, and with none inside.
    void append(std::string_view line);
    /// Any number of lines, each with its end.
    void append_lines(std::string_view lines);

    /// Of the last line, cut short, that was taken out at the start.
    std::size_t repaired_bytes() const { return repaired_bytes_; }

private:
    void repair();

    std::filesystem::path path_;
    int descriptor_ = -1;
    /// Bytes of whole lines.
    std::size_t size_ = 0;
    std::size_t repaired_bytes_ = 0;
};

}  // namespace reliefbench
