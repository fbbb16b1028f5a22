// The folder tree is the architecture. These tests read the sources as text and hold them to docs/architecture.md.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path source_root = RELIEFBENCH_SOURCE_DIR;

/// What each layer may include, itself aside. cli may include everything.
const std::map<std::string, std::set<std::string>> allowed_includes = {
    {"core", {}},
    {"scene", {"core"}},
    {"manifest", {"core"}},
    {"sweep", {"manifest", "scene", "core"}},
    {"reference", {"scene", "core"}},
    {"metrics", {"scene", "core"}},
    {"picture", {"metrics", "scene", "core"}},
    {"gpu", {"core"}},
    {"technique", {"manifest", "gpu", "scene", "core"}},
    {"store", {"sweep", "core"}},
    {"verify", {"technique", "manifest", "reference", "metrics", "scene", "gpu", "core"}},
    {"measure", {"technique", "manifest", "reference", "picture", "metrics", "scene", "gpu", "store", "sweep", "core"}},
    {"compare", {"store", "core"}},
    {"report", {"compare", "store", "core"}},
};

/// What shaders of each folder of harness/shaders may include, by the folder's name: it and these, and of `technique`
/// what a technique's folder or the harness's preamble brings. Techniques include these and their own files.
const std::map<std::string, std::set<std::string>> allowed_shader_includes = {
    {"contract", {}},
    {"library", {"contract"}},
    {"driver", {"contract", "technique"}},
};
const std::set<std::string> includes_of_techniques = {"contract", "library"};

/// Third-party headers that stay behind one interface: prefix → the files (relative to harness/) that may include them.
const std::map<std::string, std::regex> confined_includes = {
    {"vulkan/", std::regex("gpu/.*|technique/.*\\.cpp|technique/detail/.*")},
    {"OpenImageIO/", std::regex("scene/image_file\\.cpp")},
    {"embree3/", std::regex("reference/mesh_tracer\\.cpp")},
    {"glslang/", std::regex("gpu/.*\\.cpp")},
    {"SPIRV/", std::regex("gpu/.*\\.cpp")},
    {"stb_", std::regex("scene/plain_image_file\\.cpp|picture/text\\.cpp")},
    {"CLI/", std::regex("cli/.*")},
    {"benchmark/", std::regex("cli/bench_command\\.cpp")},
};

std::string read(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::vector<fs::path> files_below(const fs::path& folder, const std::set<std::string>& extensions) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file() && extensions.contains(entry.path().extension().string())) {
            files.push_back(entry.path());
        }
    }
    return files;
}

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::vector<std::string> found;
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
        found.push_back((*match)[1]);
    }
    return found;
}

const std::regex glsl_include("#\\s*include\\s*\"([^\"]+)\"");
const std::set<std::string> shader_extensions = {".glsl", ".comp", ".tesc", ".tese", ".vert", ".frag"};

/// The folder of harness/shaders in which each file lies, by its name: no two have the same.
std::map<std::string, std::string> folders_of_shared_shaders() {
    std::map<std::string, std::string> folders;
    for (const auto& entry : fs::recursive_directory_iterator(source_root / "harness/shaders")) {
        if (entry.is_directory()) continue;
        const std::string folder = entry.path().parent_path().filename().string();
        EXPECT_TRUE(allowed_shader_includes.contains(folder)) << entry.path() << " lies in a folder that is no part";
        EXPECT_TRUE(folders.emplace(entry.path().filename().string(), folder).second)
            << entry.path() << " has the name of a file of another folder, and includes are by name";
    }
    return folders;
}

std::string layer_of(const fs::path& file) {
    return fs::relative(file, source_root / "harness").begin()->string();
}

std::vector<fs::path> technique_folders() {
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(source_root / "techniques")) {
        if (entry.is_directory()) {
            folders.push_back(entry.path());
        }
    }
    return folders;
}

}  // namespace

TEST(Architecture, LayersIncludeOnlyWhatTheyMay) {
    const std::regex quoted_include("#\\s*include\\s*\"([^\"]+)\"");
    std::size_t checked = 0;
    for (const fs::path& file : files_below(source_root / "harness", {".hpp", ".cpp"})) {
        const std::string layer = layer_of(file);
        if (layer == "cli") {
            continue;
        }
        ASSERT_TRUE(allowed_includes.contains(layer)) << file << " lies in a folder that is no layer";
        for (const std::string& include : matches(read(file), quoted_include)) {
            const std::string target = include.substr(0, include.find('/'));
            EXPECT_TRUE(target == layer || allowed_includes.at(layer).contains(target))
                << file << ": " << layer << " may not include " << include;
            EXPECT_TRUE(fs::exists(source_root / "harness" / include))
                << file << ": includes are written from harness/, and there is no " << include;
            ++checked;
        }
    }
    EXPECT_GT(checked, 100U) << "found next to nothing to check";
}

TEST(Architecture, ThirdPartyHeadersStayBehindTheirInterface) {
    const std::regex angle_include("#\\s*include\\s*<([^>]+)>");
    for (const fs::path& file : files_below(source_root / "harness", {".hpp", ".cpp"})) {
        const std::string name = fs::relative(file, source_root / "harness").generic_string();
        for (const std::string& include : matches(read(file), angle_include)) {
            for (const auto& [prefix, where] : confined_includes) {
                if (include.starts_with(prefix)) {
                    EXPECT_TRUE(std::regex_match(name, where)) << name << " may not include <" << include << ">";
                }
            }
        }
    }
}

TEST(Architecture, ATypesNameIsItsOwn) {
    // Two of one name in one program: the linker would take either's destructor for both.
    const std::regex declared_namespace("\\nnamespace (reliefbench[a-z:_]*) \\{");
    const std::regex defined_type("\\n(?:struct|class|enum class) ([A-Za-z]+)(?: final)?(?: : [^;{]*)? \\{");
    std::map<std::string, fs::path> where;
    for (const fs::path& file : files_below(source_root / "harness", {".hpp"})) {
        const std::string text = read(file);
        for (const std::string& name_space : matches(text, declared_namespace)) {
            for (const std::string& type : matches(text, defined_type)) {
                const auto [known, is_new] = where.emplace(name_space + "::" + type, file);
                EXPECT_TRUE(is_new) << file << " and " << known->second << " both define " << known->first;
            }
        }
    }
    EXPECT_GT(where.size(), 100U) << "found next to nothing to check";
}

TEST(Architecture, TheHarnessNamesNoTechnique) {
    for (const fs::path& folder : technique_folders()) {
        const std::string quoted_id = "\"" + folder.filename().string() + "\"";
        for (const fs::path& file : files_below(source_root / "harness", {".hpp", ".cpp"})) {
            EXPECT_EQ(read(file).find(quoted_id), std::string::npos) << file << " names the technique " << quoted_id;
        }
    }
}

TEST(Architecture, ATechniqueIsAFolderOfShadersAndDocuments) {
    const std::set<std::string> allowed_extensions = {".json", ".md",   ".glsl", ".comp", ".tesc",
                                                      ".tese", ".vert", ".frag", ".png"};
    const std::vector<fs::path> folders = technique_folders();
    EXPECT_GE(folders.size(), 7U);
    for (const fs::path& folder : folders) {
        EXPECT_TRUE(fs::exists(folder / "technique.json")) << folder;
        EXPECT_TRUE(fs::exists(folder / "README.md")) << folder;
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            EXPECT_TRUE(entry.is_directory() || allowed_extensions.contains(entry.path().extension().string()))
                << entry.path();
        }
    }
}

TEST(Architecture, SharedShadersIncludeOnlyWhatTheirFolderMay) {
    const std::map<std::string, std::string> folder_of = folders_of_shared_shaders();
    EXPECT_GT(folder_of.size(), 40U) << "found next to nothing to check";
    for (const auto& [file, folder] : folder_of) {
        const fs::path path = source_root / "harness/shaders" / folder / file;
        for (const std::string& name : matches(read(path), glsl_include)) {
            const auto found = folder_of.find(name);
            const std::string target = found == folder_of.end() ? "technique" : found->second;
            EXPECT_TRUE(target == folder || allowed_shader_includes.at(folder).contains(target))
                << path << " may not include " << name << " of " << target;
        }
    }
}

TEST(Architecture, ATechniqueIncludesNoOtherTechniquesFiles) {
    const std::map<std::string, std::string> folder_of = folders_of_shared_shaders();
    for (const fs::path& folder : technique_folders()) {
        for (const fs::path& file : files_below(folder, shader_extensions)) {
            for (const std::string& name : matches(read(file), glsl_include)) {
                const auto found = folder_of.find(name);
                const bool is_shared = found != folder_of.end() && includes_of_techniques.contains(found->second);
                EXPECT_TRUE(fs::exists(folder / name) || is_shared)
                    << file << " includes " << name << ", which is neither its own nor of the contract or the library";
                EXPECT_EQ(name.find(".."), std::string::npos) << file << " climbs out of its folder: " << name;
            }
        }
    }
}
