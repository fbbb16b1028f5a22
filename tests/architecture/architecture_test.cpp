// The folder tree is the architecture. These tests read the sources as text and hold them to docs/architecture.md.

#include "source_tree.hpp"

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace reliefbench::test {
namespace {

namespace fs = std::filesystem;

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
    {"store", {"sweep", "metrics", "core"}},
    {"verify", {"technique", "manifest", "reference", "metrics", "scene", "gpu", "core"}},
    {"measure", {"technique", "manifest", "reference", "picture", "metrics", "scene", "gpu", "store", "sweep", "core"}},
    {"compare", {"store", "core"}},
    {"report", {"compare", "store", "core"}},
    {"advice", {"report", "compare", "store", "sweep", "manifest", "scene", "core"}},
};

/// What shaders of each folder of harness/shaders may include, by the folder's name: it and these, and of `technique`
/// what a technique's folder or the harness's preamble brings. Techniques include these and their own files.
const std::map<std::string, std::set<std::string>> allowed_shader_includes = {
    {"contract", {}},
    {"library", {"contract"}},
    {"driver", {"contract", "technique"}},
};
const std::set<std::string> includes_of_techniques = {"contract", "library"};

/// Third-party headers that stay behind one interface: prefix → the files (relative to harness/) that may include them,
/// and those that may reach them by includes of includes.
struct Confinement {
    std::string prefix;
    std::regex direct;
    std::regex reached;
};

const std::vector<Confinement>& confinements() {
    const auto only = [](const std::string& prefix, const char* where) {
        return Confinement{prefix, std::regex(where), std::regex(where)};
    };
    static const std::vector<Confinement> all{
        {"vulkan/", std::regex("gpu/vulkan\\.hpp"), std::regex("(gpu|technique)/.*")},
        only("OpenImageIO/", "scene/image_file\\.cpp"),
        only("tiny_gltf", "scene/surface/gltf_file\\.cpp"),
        only("tiny_obj_loader", "scene/surface/obj_file\\.cpp"),
        only("embree", "reference/(mesh_tracer\\.cpp|embree_scene\\.cpp|embree_handles\\.hpp)"),
        only("hwy/", "reference/packet_[a-z]*(\\.cpp|-inl\\.hpp)"),
        only("glslang/", "gpu/[a-z_]*\\.cpp"),
        only("SPIRV/", "gpu/[a-z_]*\\.cpp"),
        only("spirv/", "gpu/[a-z_]*\\.cpp"),
        only("stb_", "scene/plain_image_file\\.cpp|picture/text\\.cpp"),
        only("CLI/", "cli/.*"),
        only("benchmark/", "cli/bench_command\\.cpp"),
    };
    return all;
}

struct Include {
    std::string name;
    bool quoted = false;
};

/// Sources and headers by their name below harness/, with what each includes.
const std::map<std::string, std::vector<Include>>& includes_of_harness() {
    static const std::map<std::string, std::vector<Include>> all = [] {
        const std::regex include("#\\s*include\\s*([<\"])([^>\"]+)[>\"]");
        std::map<std::string, std::vector<Include>> found;
        for (const fs::path& file : files_below(source_root / "harness", {".hpp", ".cpp"})) {
            std::vector<Include>& includes = found[fs::relative(file, source_root / "harness").generic_string()];
            const std::string text = read(file);
            for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match)
                includes.push_back({(*match)[2], (*match)[1] == "\""});
        }
        return found;
    }();
    return all;
}

/// What the file includes that is not of the harness, itself or by others: header → the last file on the way there.
std::map<std::string, std::string> reached_from(const std::string& file) {
    std::map<std::string, std::string> reached;
    std::set<std::string> seen;
    std::vector<std::string> left{file};
    while (!left.empty()) {
        const std::string next = left.back();
        left.pop_back();
        if (!seen.insert(next).second) continue;
        for (const Include& include : includes_of_harness().at(next)) {
            if (includes_of_harness().contains(include.name)) {
                left.push_back(include.name);
            } else {
                reached.emplace(include.name, next);
            }
        }
    }
    return reached;
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

std::string layer_of(const std::string& file) {
    return file.substr(0, file.find('/'));
}

}  // namespace

TEST(Architecture, LayersIncludeOnlyWhatTheyMay) {
    std::size_t checked = 0;
    for (const auto& [file, includes] : includes_of_harness()) {
        const std::string layer = layer_of(file);
        for (const Include& include : includes) {
            const std::string& name = include.name;
            if (!include.quoted) {
                EXPECT_FALSE(fs::exists(source_root / "harness" / name))
                    << file << ": <" << name << "> is to be quoted";
                continue;
            }
            EXPECT_TRUE(fs::exists(source_root / "harness" / name))
                << file << ": includes are written from harness/, and there is no " << name;
            if (layer == "cli") continue;
            ASSERT_TRUE(allowed_includes.contains(layer)) << file << " lies in a folder that is no layer";
            const std::string target = layer_of(name);
            EXPECT_TRUE(target == layer || allowed_includes.at(layer).contains(target))
                << file << ": " << layer << " may not include " << name;
            ++checked;
        }
    }
    EXPECT_GT(checked, 100U) << "found next to nothing to check";
}

TEST(Architecture, ThirdPartyHeadersStayBehindTheirInterface) {
    std::set<std::string> met;
    for (const auto& [file, includes] : includes_of_harness()) {
        const std::map<std::string, std::string> reached = reached_from(file);
        for (const auto& [prefix, direct, indirect] : confinements()) {
            for (const Include& include : includes) {
                if (!include.name.starts_with(prefix)) continue;
                met.insert(prefix);
                EXPECT_TRUE(std::regex_match(file, direct)) << file << " may not include " << include.name;
            }
            for (const auto& [header, by] : reached) {
                if (header.starts_with(prefix)) {
                    EXPECT_TRUE(std::regex_match(file, indirect)) << file << " reaches " << header << " by " << by;
                }
            }
        }
    }
    for (const char* prefix : {"vulkan/", "OpenImageIO/", "tiny_gltf", "tiny_obj_loader", "embree", "glslang/", "CLI/"})
        EXPECT_TRUE(met.contains(prefix)) << "nothing includes " << prefix << ": what confines it checks nothing";
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

// What two techniques need belongs to harness/shaders/library. Of preparation passes comments and spaces do not count.
TEST(Architecture, NoTwoTechniquesHaveTheSameShader) {
    const std::regex comment_or_space("//[^\n]*|\\s+");
    std::map<std::string, fs::path> where;
    for (const fs::path& folder : technique_folders()) {
        for (const fs::path& file : files_below(folder, shader_extensions)) {
            std::string text = read(file);
            if (text.find("void prepare(") != std::string::npos) text = std::regex_replace(text, comment_or_space, "");
            const auto [known, is_new] = where.emplace(text, file);
            EXPECT_TRUE(is_new || known->second.parent_path() == folder) << file << " is the same as " << known->second;
        }
    }
    EXPECT_GT(where.size(), 25U) << "found next to nothing to check";
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

}  // namespace reliefbench::test
