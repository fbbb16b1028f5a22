#include "technique/source_identity.hpp"

#include "core/file.hpp"
#include "core/hash.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

/// A technique with a pass, and shared shaders that include back into its folder.
class SourceIdentity : public testing::Test {
protected:
    SourceIdentity() {
        write("own/technique.json", "{}");
        write("own/trace.glsl", "#include \"shared.glsl\"\n  #  include \"parts/search.glsl\"\n");
        write("own/parts/search.glsl", "float search;\n");
        write("own/fill.glsl", "void prepare(ivec2 texel) {}\n");
        write("own/back.glsl", "float back;\n");
        write("shaders/quad.frag", "#include \"trace.glsl\"\n");
        write("shaders/shared.glsl", "#include \"back.glsl\"\n#include \"missing.glsl\"\n");
        manifest_.passes.emplace_back();
        manifest_.passes.back().name = "fill";
        manifest_.passes.back().shader = "fill.glsl";
    }

    void write(const std::string& file, const std::string& text) const {
        fs::create_directories((folder_.path() / file).parent_path());
        write_text_file(folder_.path() / file, text);
    }

    std::vector<fs::path> files() const { return source_files(manifest_, own(), shaders()); }
    std::string hash() const { return hash_technique(manifest_, own(), shaders()); }
    fs::path own() const { return folder_.path() / "own"; }
    fs::path shaders() const { return folder_.path() / "shaders"; }

    Manifest manifest_;

private:
    TemporaryFolder folder_;
};

TEST_F(SourceIdentity, IsWhatCompilationsIncludeDirectlyAndThroughSharedFiles) {
    EXPECT_THAT(files(), ElementsAre("back.glsl", "fill.glsl", "parts/search.glsl", "technique.json", "trace.glsl"));
}

TEST_F(SourceIdentity, EveryIncludedFileAndTheManifestChangeIt) {
    for (const char* file : {"back.glsl", "fill.glsl", "parts/search.glsl", "technique.json", "trace.glsl"}) {
        const std::string before = hash();
        write(std::string("own/") + file, read_text_file(own() / file) + " ");
        EXPECT_NE(hash(), before) << file;
    }
    const std::string before = hash();
    write("own/missing.glsl", "float found;\n");
    EXPECT_NE(hash(), before) << "a file that is included now";
}

TEST_F(SourceIdentity, WhatEditorsLeaveBehindDoesNot) {
    const std::string before = hash();
    const std::string shared = hash_shared_shaders(shaders());
    for (const char* file : {".trace.glsl.swp", "trace.glsl~", "#trace.glsl#", "trace.glsl.orig", "trace copy.glsl",
                             "4913", "README.md", "old/trace.glsl"}) {
        write(std::string("own/") + file, "anything");
        if (std::string(file).find("copy") == std::string::npos && std::string(file).find("old/") == std::string::npos)
            write(std::string("shaders/") + file, "anything");
    }
    EXPECT_EQ(hash(), before);
    EXPECT_EQ(hash_shared_shaders(shaders()), shared);
    write("shaders/shared.glsl", "float other;\n");
    EXPECT_NE(hash_shared_shaders(shaders()), shared);
}

TEST_F(SourceIdentity, SharedShadersAreTheSameInWhicheverFolderTheyStand) {
    const std::string flat = hash_shared_shaders(shaders());
    const std::string of_technique = hash();
    for (const auto& [folder, file] : {std::pair{"driver", "quad.frag"}, std::pair{"library", "shared.glsl"}}) {
        fs::create_directories(shaders() / folder);
        fs::rename(shaders() / file, shaders() / folder / file);
    }
    fs::create_directories(shaders() / "contract");
    EXPECT_EQ(hash_shared_shaders(shaders()), flat);
    EXPECT_EQ(hash(), of_technique);
    write("shaders/library/shared.glsl", "float other;\n");
    EXPECT_NE(hash_shared_shaders(shaders()), flat);
}

TEST_F(SourceIdentity, CommentsIncludeNothing) {
    write("own/trace.glsl",
          "// #include \"back.glsl\"\n/* \n#include \"parts/search.glsl\"\n*/\n// goes on \\\n#include \"fill2.glsl\"\n"
          "#/* so */include \"back.glsl\" // indeed\n");
    write("own/fill2.glsl", "");
    EXPECT_THAT(files(), ElementsAre("back.glsl", "fill.glsl", "technique.json", "trace.glsl"));
}

TEST_F(SourceIdentity, FilesThatIncludeEachOtherEnd) {
    write("own/back.glsl", "#include \"trace.glsl\"\n");
    EXPECT_EQ(files().size(), 5U);
}

/// So that runs of version 0.1.0, whose hashes are of all files, are found to have the same sources where they have.
TEST_F(SourceIdentity, OfAFolderWithNothingElseIsTheHashOfVersion010) {
    std::string digest;
    for (const char* file : {"back.glsl", "fill.glsl", "parts/search.glsl", "technique.json", "trace.glsl"})
        digest += std::string(file) + '\n' + content_hash(read_text_file(own() / file)) + '\n';
    EXPECT_EQ(hash(), content_hash(digest));
}

TEST_F(SourceIdentity, OfPatchesItBeginsAtTheirStages) {
    manifest_.shape.kind = "patches";
    manifest_.passes.clear();
    write("own/control.tesc", "");
    write("own/evaluation.tese", "#include \"back.glsl\"\n");
    EXPECT_THAT(files(), ElementsAre("back.glsl", "control.tesc", "evaluation.tese", "technique.json"));
}

}  // namespace
}  // namespace reliefbench
