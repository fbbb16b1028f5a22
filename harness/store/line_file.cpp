#include "store/line_file.hpp"

#include "core/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <cstring>
#include <string>

namespace reliefbench {

namespace {

constexpr mode_t read_and_write_for_all = 0666;  // less the process's umask

/// False, with errno set, when not all of it could be written.
bool write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace

LineFile::LineFile(const std::filesystem::path& path)
    : path_(path),
      descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, read_and_write_for_all)) {
    if (descriptor_ < 0) fail("cannot create {}: {}", path_.string(), std::strerror(errno));
}

LineFile::~LineFile() {
    ::close(descriptor_);
}

void LineFile::append(std::string_view line) {
    assert(line.find('\n') == std::string_view::npos);
    const std::string text = std::string(line) + '\n';
    if (write_all(descriptor_, text)) {
        size_ += text.size();
        return;
    }
    const std::string reason = std::strerror(errno);
    const bool taken_back = ::ftruncate(descriptor_, static_cast<off_t>(size_)) == 0;
    fail("cannot write to {}: {}. {}", path_.string(), reason,
         taken_back ? "What was written before is whole; make room and run again"
                    : "Its last line may be incomplete; make room and run again");
}

}  // namespace reliefbench
