#include "store/line_file.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <thread>

namespace reliefbench {

namespace {

constexpr mode_t read_and_write_for_all = 0666;  // less the process's umask

/// False when another process holds the file, and goes on to.
bool lock(int descriptor) {
    constexpr int tries = 40;
    constexpr std::chrono::milliseconds between_tries{50};
    for (int attempt = 0; attempt < tries; ++attempt) {
        if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return true;
        std::this_thread::sleep_for(between_tries);
    }
    return false;
}

bool was_removed(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink == 0;
}

/// How many bytes of the file are whole lines.
std::size_t whole_lines(int descriptor, std::size_t size) {
    constexpr std::size_t chunk = 65536;
    std::string text(chunk, '\0');
    for (std::size_t end = size; end > 0;) {
        const std::size_t begin = end - std::min(end, chunk);
        const ssize_t count = ::pread(descriptor, text.data(), end - begin, static_cast<off_t>(begin));
        if (count != static_cast<ssize_t>(end - begin)) fail("{}", std::strerror(errno));
        const std::size_t newline = std::string_view(text).substr(0, end - begin).rfind('\n');
        if (newline != std::string_view::npos) return begin + newline + 1;
        end = begin;
    }
    return 0;
}

}  // namespace

LineFile::LineFile(const std::filesystem::path& path, Start start)
    : path_(path),
      descriptor_(::open(path.c_str(), O_RDWR | O_CREAT | (start == Start::created ? O_EXCL : 0) | O_APPEND | O_CLOEXEC,
                         read_and_write_for_all)) {
    if (descriptor_ < 0) {
        fail("cannot {} {}: {}", start == Start::created ? "create" : "open", path_.string(), std::strerror(errno));
    }
    try {
        if (!lock(descriptor_)) {
            fail("{} is being written by another process; wait for it, or choose another folder", path_.string());
        }
        if (start == Start::continued) repair();
    } catch (const Error&) {
        ::close(descriptor_);
        throw;
    }
}

void LineFile::repair() {
    const off_t size = ::lseek(descriptor_, 0, SEEK_END);
    if (size < 0) fail("cannot read {}: {}", path_.string(), std::strerror(errno));
    try {
        size_ = whole_lines(descriptor_, static_cast<std::size_t>(size));
    } catch (const Error& error) {
        fail("cannot read {}: {}", path_.string(), error.what());
    }
    repaired_bytes_ = static_cast<std::size_t>(size) - size_;
    if (repaired_bytes_ > 0 && ::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) {
        fail("cannot take the incomplete last line out of {}: {}", path_.string(), std::strerror(errno));
    }
}

LineFile::~LineFile() {
    ::close(descriptor_);
}

void LineFile::append(std::string_view line) {
    assert(line.find('\n') == std::string_view::npos);
    append_lines(std::string(line) + '\n');
}

void LineFile::append_lines(std::string_view lines) {
    assert(lines.empty() || lines.back() == '\n');
    if (was_removed(descriptor_)) {
        fail("{} was removed while it was being written; what was measured since is lost, run again", path_.string());
    }
    if (write_all(descriptor_, lines)) {
        size_ += lines.size();
        return;
    }
    const std::string reason = std::strerror(errno);
    const bool taken_back = ::ftruncate(descriptor_, static_cast<off_t>(size_)) == 0;
    fail("cannot write to {}: {}. {}", path_.string(), reason,
         taken_back ? "What was written before is whole; make room and run again"
                    : "Its last line may be incomplete; make room and run again");
}

}  // namespace reliefbench
