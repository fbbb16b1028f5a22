#include "technique/baseline_sources.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/process.hpp"
#include "manifest/shared_shaders.hpp"
#include "technique/technique.hpp"

#include <algorithm>
#include <optional>
#include <regex>

namespace reliefbench {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t shown_commit_digits = 12;

/// In `folder`'s repository, whatever repository a hook that started us works on.
FinishedProcess git(const fs::path& folder, const std::vector<std::string>& arguments) {
    std::vector<std::string> command{"git", "--no-optional-locks", "-C", folder.string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return run_process(command, {"GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX"});
}

std::string without_line_end(std::string text) {
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    return text;
}

/// A folder of a git work tree.
struct RepositoryFolder {
    fs::path top;
    /// The folder's path below `top`; "." for the top itself.
    fs::path inside;
};

std::optional<RepositoryFolder> find_in_repository(const fs::path& folder) {
    const FinishedProcess found = git(folder, {"rev-parse", "--show-toplevel"});
    if (found.exit_code != 0) return std::nullopt;
    const fs::path top = without_line_end(found.output);
    return RepositoryFolder{top, fs::canonical(folder).lexically_relative(fs::canonical(top))};
}

std::string resolve_commit(const fs::path& top, const std::string& revision) {
    const std::string problem =
        fmt::format("the baseline '{}' is neither a folder nor a revision of {}", revision, top.string());
    // git would take it for an option, and the end of options is not known to all of its commands.
    if (revision.empty())
        fail("the baseline is empty; name a commit, branch or tag, or a folder that holds techniques");
    if (revision.front() == '-') fail("{}: revisions do not begin with '-'", problem);
    const FinishedProcess found =
        git(top, {"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"});
    if (found.exit_code != 0) {
        const std::string words = without_line_end(found.errors);
        fail("{}{}{}; name a commit, branch or tag (see `git log`), or a folder that holds techniques", problem,
             words.empty() ? "" : ": ", words);
    }
    return without_line_end(found.output);
}

/// Files of `inside` at the commit, by their paths below the repository's top. Links and submodules are left out.
std::vector<std::string> files_at(const RepositoryFolder& folder, const std::string& commit) {
    const FinishedProcess listed =
        git(folder.top, {"ls-tree", "-r", "-z", "--full-tree", commit, "--", folder.inside.generic_string()});
    if (listed.exit_code != 0) fail("cannot list {} at {}: {}", folder.inside.string(), commit, listed.errors);
    std::vector<std::string> files;
    // Of each entry: "<mode> blob <id>\t<path>\0".
    for (std::size_t begin = 0; begin < listed.output.size();) {
        const std::size_t end = std::min(listed.output.find('\0', begin), listed.output.size());
        const std::string entry = listed.output.substr(begin, end - begin);
        const std::size_t tab = entry.find('\t');
        if (entry.starts_with("100") && tab != std::string::npos) files.push_back(entry.substr(tab + 1));
        begin = end + 1;
    }
    return files;
}

/// Where the folder lies now; empty when it has no files at the commit.
std::optional<fs::path> copy_from_revision(const RepositoryFolder& folder, const std::string& commit,
                                           const fs::path& scratch) {
    const std::vector<std::string> files = files_at(folder, commit);
    for (const std::string& file : files) {
        const FinishedProcess content = git(folder.top, {"cat-file", "blob", commit + ":" + file});
        if (content.exit_code != 0) fail("cannot read {} at {}: {}", file, commit, content.errors);
        fs::create_directories((scratch / file).parent_path());
        write_text_file(scratch / file, content.output);
    }
    if (files.empty()) return std::nullopt;
    return (scratch / folder.inside).lexically_normal();
}

TechniqueSources sources_of_revision(const std::string& revision, const TechniqueSources& own,
                                     const fs::path& scratch) {
    std::optional<RepositoryFolder> repository;
    for (const fs::path& root : own.roots) {
        if (auto found = find_in_repository(root)) repository = std::move(found);
    }
    if (!repository) {
        fail("the baseline '{}' is no folder, and no revision either: {} is in no git repository", revision,
             own.roots.front().string());
    }
    const fs::path top = repository->top;
    const std::string commit = resolve_commit(top, revision);
    const auto at_revision = [&](const fs::path& folder) -> std::optional<fs::path> {
        const auto found = find_in_repository(folder);
        if (!found || found->top != top) return folder;
        return copy_from_revision(*found, commit, scratch);
    };
    TechniqueSources sources;
    std::vector<fs::path> of_revision;
    for (const fs::path& root : own.roots) {
        auto copy = at_revision(root);
        if (copy) (*copy == root ? sources.roots : of_revision).push_back(std::move(*copy));
    }
    // Where a technique of the revision has the id of one that lies elsewhere, it is what that one is compared with.
    sources.roots.insert(sources.roots.end(), of_revision.begin(), of_revision.end());
    const std::optional<fs::path> shaders = at_revision(own.shaders);
    if (sources.roots.empty() || !shaders) {
        fail("revision '{}' of {} has no {}", revision, top.string(),
             sources.roots.empty() ? "techniques" : "shared shaders (harness/shaders)");
    }
    sources.shaders = *shaders;
    sources.description =
        fmt::format("revision {} ({}) of {}", revision, commit.substr(0, shown_commit_digits), top.string());
    return sources;
}

TechniqueSources sources_of_folder(const fs::path& folder, const TechniqueSources& own) {
    TechniqueSources sources{{folder}, own.shaders, "folder " + folder.string()};
    if (fs::is_directory(folder / "techniques")) {
        sources.roots = {folder / "techniques"};
        const fs::path shaders = folder / "harness" / "shaders";
        if (fs::is_directory(shaders)) sources.shaders = shaders;
    }
    if (const std::string complaint = complaint_of_root(sources.roots.front()); !complaint.empty())
        fail("the baseline {}", complaint);
    return sources;
}

}  // namespace

TechniqueSources find_baseline(const std::string& baseline, const TechniqueSources& own, const fs::path& scratch) {
    std::error_code missing;
    TechniqueSources sources = fs::is_directory(baseline, missing) ? sources_of_folder(baseline, own)
                                                                   : sources_of_revision(baseline, own, scratch);
    if (shader_interface(sources.shaders) != shader_interface(own.shaders)) {
        sources.shaders = own.shaders;
        sources.notices.push_back(
            "the base's shared shaders (harness/shaders) are made for another version of the harness, which binds "
            "other "
            "things to them: both sides are compiled with the work tree's, so that only techniques differ");
    }
    return sources;
}

std::vector<std::string> shader_interface(const fs::path& shaders) {
    static const std::regex comment("//[^\n]*");
    static const std::regex declaration(
        R"(layout\s*\([^)]*\b(set|constant_id|push_constant)\b[^)]*\)[^;{]*(\{[^}]*\}[^;]*)?;)");
    static const std::regex structure(R"(struct\s+(\w+)\s*\{[^}]*\}\s*;)");
    static const std::regex space("\\s+");
    std::vector<std::string> interface;
    const auto add = [&](const std::string& text) { interface.push_back(std::regex_replace(text, space, " ")); };
    std::vector<fs::path> files;
    for (const fs::path& folder : shared_shader_folders(shaders)) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
            if (entry.is_regular_file()) files.push_back(entry.path());
        }
    }
    for (const fs::path& file : files) {
        const std::string text = std::regex_replace(read_text_file(file), comment, "");
        std::string blocks;
        for (std::sregex_iterator found(text.begin(), text.end(), declaration), end; found != end; ++found) {
            add(found->str());
            blocks += found->str();
        }
        // Blocks may hold structures.
        for (std::sregex_iterator found(text.begin(), text.end(), structure), end; found != end; ++found) {
            if (blocks.find((*found)[1]) != std::string::npos) add(found->str());
        }
    }
    std::sort(interface.begin(), interface.end());
    return interface;
}

}  // namespace reliefbench
