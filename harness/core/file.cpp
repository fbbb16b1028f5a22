#include "core/file.hpp"

#include "core/error.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace reliefbench {

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

std::string system_reason() {
    return std::strerror(errno);
}

std::string read_to_end(std::FILE* file, const std::string& name, std::uint64_t max_bytes) {
    std::string text;
    char buffer[65536];
    while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file)) {
        text.append(buffer, count);
        if (text.size() > max_bytes) fail("cannot read {}: it is larger than {} bytes", name, max_bytes);
    }
    if (std::ferror(file) != 0) fail("cannot read {}: {}", name, system_reason());
    return text;
}

void write_whole(const std::filesystem::path& path, std::string_view text) {
    FileHandle file(std::fopen(path.c_str(), "wb"));
    if (!file) fail("{}: {}", path.string(), system_reason());
    const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
    if (!written || std::fflush(file.get()) != 0) fail("{}: {}", path.string(), system_reason());
    if (std::fclose(file.release()) != 0) fail("{}: {}", path.string(), system_reason());
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
    const FileHandle file(std::fopen(path.c_str(), "rb"));
    if (!file) fail("cannot read {}: {}", path.string(), system_reason());
    return read_to_end(file.get(), path.string(), max_bytes);
}

std::string read_standard_input(std::uint64_t max_bytes) {
    return read_to_end(stdin, "standard input", max_bytes);
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    // The process in the name keeps two processes from writing the same file beside it.
    const std::filesystem::path partial = path.string() + fmt::format(".{}.partial", getpid());
    try {
        write_whole(partial, text);
        std::filesystem::rename(partial, path);
    } catch (const std::exception& failure) {
        std::error_code ignored;
        std::filesystem::remove(partial, ignored);
        fail("cannot write {}: {}", path.string(), failure.what());
    }
}

bool write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace reliefbench
