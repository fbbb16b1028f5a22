#include "technique/source_identity.hpp"

#include "core/file.hpp"
#include "core/hash.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <string_view>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

/// As the compiler's.
constexpr std::uint64_t largest_source = std::uint64_t{4} << 20;

/// Each comment is a space, as the preprocessor sees it.
std::string without_comments(std::string_view text) {
    std::string plain;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at);
        if (rest.starts_with("//")) {
            at = std::min(text.find('\n', at), text.size());
        } else if (rest.starts_with("/*")) {
            const std::size_t end = text.find("*/", at + 2);
            at = end == std::string_view::npos ? text.size() : end + 2;
            plain += ' ';
        } else {
            plain += text[at++];
        }
    }
    return plain;
}

std::vector<std::string> included_names(const std::string& text) {
    static const std::regex directive(R"re((^|\n)[ \t]*#[ \t]*include[ \t]*["<]([^">\n]+)[">])re");
    // Lines that go on are joined first, so that a comment may go on, too.
    static const std::regex line_goes_on("\\\\\r?\n");
    const std::string plain = without_comments(std::regex_replace(text, line_goes_on, ""));
    std::vector<std::string> names;
    for (std::sregex_iterator found(plain.begin(), plain.end(), directive), end; found != end; ++found)
        names.push_back((*found)[2]);
    return names;
}

/// Follows includes from file to file. Files that are missing are the compiler's to complain of.
class IncludedFiles {
public:
    IncludedFiles(fs::path own, fs::path shared) : own_(std::move(own)), shared_(std::move(shared)) {}

    void add(const fs::path& name) {
        const fs::path plain = name.lexically_normal();
        if (!seen_.insert(plain).second) return;
        for (const fs::path& root : {own_, shared_}) {
            std::error_code ignored;
            if (!fs::is_regular_file(root / plain, ignored)) continue;
            if (root == own_) of_own_.insert(plain);
            for (const std::string& included : included_names(read_text_file(root / plain, largest_source)))
                add(included);
        }
    }

    const std::set<fs::path>& of_own() const { return of_own_; }

private:
    fs::path own_;
    fs::path shared_;
    std::set<fs::path> seen_;
    std::set<fs::path> of_own_;
};

std::string hash_files(const fs::path& folder, const std::vector<fs::path>& files) {
    std::string digest;
    for (const fs::path& file : files)
        digest += file.generic_string() + '\n' + content_hash(read_text_file(folder / file)) + '\n';
    return content_hash(digest);
}

}  // namespace

std::vector<fs::path> source_files(const Manifest& manifest, const fs::path& folder, const fs::path& shaders) {
    IncludedFiles included(folder, shaders);
    if (manifest.shape.kind == Shape::Kind::quad) {
        included.add("trace.glsl");
    } else {
        included.add("control.tesc");
        included.add("evaluation.tese");
    }
    for (const PassDeclaration& pass : manifest.passes)
        included.add(pass.shader);
    std::vector<fs::path> files(included.of_own().begin(), included.of_own().end());
    files.emplace_back("technique.json");
    std::sort(files.begin(), files.end());
    return files;
}

std::string hash_technique(const Manifest& manifest, const fs::path& folder, const fs::path& shaders) {
    return hash_files(folder, source_files(manifest, folder, shaders));
}

std::string hash_shared_shaders(const fs::path& folder) {
    constexpr std::array<std::string_view, 7> extensions{".comp", ".frag", ".glsl", ".json", ".tesc", ".tese", ".vert"};
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path name = entry.path().filename();
        const bool is_source = std::ranges::find(extensions, name.extension().string()) != extensions.end();
        if (entry.is_regular_file() && is_source && !name.string().starts_with('.'))
            files.push_back(entry.path().lexically_relative(folder));
    }
    std::sort(files.begin(), files.end());
    return hash_files(folder, files);
}

}  // namespace reliefbench
