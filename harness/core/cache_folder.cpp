#include "core/cache_folder.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/hash.hpp"
#include "core/log.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

namespace reliefbench {

namespace fs = std::filesystem;

fs::path cache_folder() {
    const auto variable = [](const char* name) -> fs::path {
        const char* value = std::getenv(name);
        return value == nullptr ? "" : value;
    };
    if (const fs::path own = variable("RELIEFBENCH_CACHE_DIR"); !own.empty()) return own;
    if (const fs::path caches = variable("XDG_CACHE_HOME"); !caches.empty()) return caches / "reliefbench";
    const fs::path home = variable("HOME");
    return home.empty() ? fs::path() : home / ".cache" / "reliefbench";
}

std::string_view take_line(std::string_view& text) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    return line;
}

fs::path CachedFiles::file_of(const std::string& key) const {
    return folder / (key + extension);
}

bool CachedFiles::read(const std::string& key, const std::function<void(std::string_view)>& take) const {
    if (folder.empty()) return false;
    const fs::path file = file_of(key);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return false;
    try {
        const std::string bytes = read_text_file(file);
        std::string_view text = bytes;
        const std::string_view hash = take_line(text);
        if (hash != content_hash(text)) fail("its content is not what was written");
        take(text);
        fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
        return true;
    } catch (const Error& error) {
        log_warning("{}: the {} cached there cannot be used and are made anew: {}", file.string(), content,
                    error.what());
        return false;
    }
}

void CachedFiles::write(const std::string& key, std::string bytes) const {
    if (folder.empty()) return;
    try {
        fs::create_directories(folder);
        bytes.insert(0, content_hash(bytes) + '\n');
        write_text_file(file_of(key), bytes);
        make_room();
    } catch (const std::exception& error) {
        log_warning("{} cannot be cached in {}: {}; name another folder with RELIEFBENCH_CACHE_DIR", content,
                    folder.string(), error.what());
    }
}

void CachedFiles::make_room() const {
    struct File {
        fs::file_time_type used;
        std::uint64_t bytes;
        fs::path path;
    };
    std::vector<File> files;
    std::uint64_t total = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != extension) continue;
        // Another process may have removed it meanwhile.
        std::error_code gone;
        const std::uint64_t bytes = entry.file_size(gone);
        const fs::file_time_type used = gone ? fs::file_time_type() : entry.last_write_time(gone);
        if (gone) continue;
        files.push_back({used, bytes, entry.path()});
        total += bytes;
    }
    std::ranges::sort(files, {}, &File::used);
    for (auto file = files.begin(); file != files.end() && total > max_bytes; ++file) {
        fs::remove(file->path);
        total -= file->bytes;
    }
}

}  // namespace reliefbench
