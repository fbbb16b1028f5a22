#pragma once

#include <filesystem>
#include <string_view>

namespace reliefbench {

/// A file of whole lines that only grows. Every append is handed to the system at once, so that lines outlive the
/// process; one that fails is an Error and is taken back, so that no reader ever sees half a line.
class LineFile {
public:
    /// Creates the file; one that exists already is an Error.
    explicit LineFile(const std::filesystem::path& path);
    ~LineFile();
    LineFile(const LineFile&) = delete;
    LineFile& operator=(const LineFile&) = delete;

    /// `line` without its end, and with none inside.
    void append(std::string_view line);

private:
    std::filesystem::path path_;
    int descriptor_ = -1;
    /// Bytes of whole lines.
    std::size_t size_ = 0;
};

}  // namespace reliefbench
