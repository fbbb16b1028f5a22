#include "core/file.hpp"
#include "scene/surface/base_surface.hpp"
#include "scene/surface/file_base.hpp"
#include "scene/surface/generated_base.hpp"
#include "support/closed_cylinder.hpp"
#include "support/error_message.hpp"
#include "support/mesh_writer.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <functional>

namespace reliefbench {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const TemporaryFolder folder;

BaseMesh load(const std::string& name, const std::string& content, BaseSource::Fit fit = BaseSource::Fit::none) {
    const std::filesystem::path path = folder.path() / name;
    write_text_file(path, content);
    return load_file_base({.kind = BaseSource::Kind::file, .file = path, .fit = fit});
}

std::string complaint_about(const std::string& name, const std::string& content) {
    return error_message([&] { load(name, content); });
}

BaseMesh small_cylinder() {
    return generate_base({.kind = BaseSource::Kind::cylinder, .curvature = 2, .segments = 4});
}

/// The asset of small_cylinder() with changes.
std::string glb_with(const std::function<void(Json&)>& change) {
    GltfAsset asset = gltf_of(small_cylinder());
    change(asset.json);
    return as_glb(asset);
}

void expect_near(const BaseMesh& mesh, const BaseMesh& expected, float tolerance) {
    ASSERT_EQ(mesh.triangles.size(), expected.triangles.size());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const MeshVertex& found = mesh.vertices[mesh.triangles[triangle][corner]];
            const MeshVertex& wanted = expected.vertices[expected.triangles[triangle][corner]];
            EXPECT_LE(glm::distance(found.position, wanted.position), tolerance);
            EXPECT_LE(glm::distance(found.normal, wanted.normal), tolerance);
            EXPECT_LE(glm::distance(found.uv, wanted.uv), tolerance);
        }
    }
}

TEST(MeshFile, AGeneratedBaseComesBackBitForBit) {
    for (const BaseSource::Kind kind :
         {BaseSource::Kind::cylinder, BaseSource::Kind::sphere, BaseSource::Kind::saddle}) {
        const BaseMesh mesh = generate_base({.kind = kind, .curvature = 1.7, .segments = 64});
        const GltfAsset asset = gltf_of(mesh);
        write_text_file(folder.path() / "buffer of it.bin", asset.buffer);
        for (const BaseMesh& read :
             {load("base.glb", as_glb(asset)), load("base.gltf", as_gltf(asset, "buffer%20of%20it.bin"))}) {
            EXPECT_EQ(read.vertices, mesh.vertices);
            EXPECT_EQ(read.triangles, mesh.triangles);
            EXPECT_EQ(read.charts, mesh.charts);
            EXPECT_EQ(read.chart_periods, mesh.chart_periods);
            EXPECT_TRUE(read.is_unit_square);
            EXPECT_EQ(read.scale, 1);
            EXPECT_THAT(read.warnings, IsEmpty());
        }
        expect_near(load("base.obj", as_obj(mesh)), mesh, 1e-6f);
    }
}

TEST(MeshFile, IsFittedToThePatch) {
    BaseMesh mesh = small_cylinder();
    for (MeshVertex& vertex : mesh.vertices)
        vertex.position = vertex.position * 50.0f + glm::vec3(100, -3, 7);
    const BaseMesh fitted = load("large.GLB", as_glb(gltf_of(mesh)), BaseSource::Fit::unit);
    EXPECT_NEAR(fitted.scale, 1 / 50.0, 1e-6);
    glm::vec3 low(9);
    glm::vec3 high(-9);
    for (const MeshVertex& vertex : fitted.vertices) {
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
    }
    EXPECT_NEAR(high.x - low.x, 1, 1e-5);
    EXPECT_LE(glm::length(low + high), 1e-5f);
    EXPECT_EQ(load("large.glb", as_glb(gltf_of(mesh))).vertices, mesh.vertices);
}

TEST(MeshFile, NodesPlaceTheirMeshesAndMirrorsKeepTheFront) {
    const BaseMesh mesh = small_cylinder();
    const BaseMesh placed = load("placed.glb", glb_with([](Json& json) {
                                     json["nodes"] = parse_json(R"([
                                         {"children": [1, 2], "translation": [5, 0, 0]},
                                         {"mesh": 0, "scale": [-1, 1, 1]},
                                         {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476],
                                          "scale": [2, 1, 1]}])",
                                                                "nodes");
                                 }));
    ASSERT_EQ(placed.triangles.size(), 2 * mesh.triangles.size());
    ASSERT_EQ(placed.vertices.size(), 2 * mesh.vertices.size());
    for (std::size_t triangle = 0; triangle < placed.triangles.size(); ++triangle) {
        const BaseTriangle shape = base_triangle(placed, triangle);
        for (const std::uint32_t corner : placed.triangles[triangle])
            EXPECT_GT(glm::dot(shape.facet_normal, glm::dvec3(placed.vertices[corner].normal)), 0.9);
    }
    std::size_t mirrored = 0;
    for (std::size_t triangle = 0; triangle < placed.triangles.size(); ++triangle)
        mirrored += chart_area(placed, triangle) < 0 ? 1 : 0;
    EXPECT_EQ(mirrored, mesh.triangles.size());
    // Of the second node, whose normals follow the inverse transpose: a cylinder stretched along its axis keeps them.
    const auto expect_equal = [](const glm::vec3& found, const glm::vec3& wanted) {
        EXPECT_LE(glm::distance(found, wanted), 1e-6f) << found.x << " " << found.y << " " << found.z;
    };
    const bool rotated_first = placed.vertices[0].position.x > 5.4f;
    const std::size_t rotated = rotated_first ? 0 : mesh.vertices.size();
    for (std::size_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
        const MeshVertex& from = mesh.vertices[vertex];
        const MeshVertex& to = placed.vertices[rotated + vertex];
        expect_equal(to.position, {5 - from.position.y, 2 * from.position.x, from.position.z});
        expect_equal(to.normal, {-from.normal.y, from.normal.x, from.normal.z});
    }
}

TEST(MeshFile, PartsStripsAndFansAreRead) {
    GltfAsset asset = gltf_of(small_cylinder());
    // The vertices 0 to 9 are two rows of five: as a strip of eight triangles, and the first as a fan without indices.
    const std::size_t begin = asset.buffer.size();
    for (const int index : {0, 5, 1, 6, 2, 7, 3, 8, 4, 9})
        asset.buffer += static_cast<char>(index);
    asset.json["buffers"][0]["byteLength"] = asset.buffer.size();
    asset.json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", begin}, {"byteLength", 10}});
    asset.json["accessors"].push_back({{"bufferView", 4}, {"componentType", 5121}, {"count", 10}, {"type", "SCALAR"}});
    Json& primitives = asset.json["meshes"][0]["primitives"];
    primitives.push_back(primitives[0]);
    primitives[1]["mode"] = 5;
    primitives[1]["indices"] = 4;
    primitives.push_back(primitives[1]);
    primitives[2]["mode"] = 1;
    const BaseMesh mesh = load("parts.glb", as_glb(asset));
    ASSERT_EQ(mesh.triangles.size(), 32U + 8U);
    // Both turn as their first triangle does, which is from behind.
    for (std::size_t triangle = 32; triangle < 40; ++triangle)
        EXPECT_LT(base_triangle(mesh, triangle).facet_normal.z, 0);
    EXPECT_THAT(mesh.triangles[33], ElementsAre(25 + 5, 25 + 6, 25 + 1));
}

TEST(MeshFile, NormalsThatItLacksAreMeansOfFacetsByAreaAndAngle) {
    // Of a closed cylinder whose seam has its vertices twice, rounded differently: both have one normal.
    BaseMesh mesh = closed_cylinder(64, 8);
    for (std::size_t row = 0; row <= 8; ++row)
        mesh.vertices[65 * row + 64].position.z += 1e-8f;
    for (const std::string& name : {std::string("bare.obj"), std::string("bare.glb")}) {
        GltfAsset asset = gltf_of(mesh);
        asset.json["meshes"][0]["primitives"][0]["attributes"].erase("NORMAL");
        const BaseMesh bare = load(name, name == "bare.obj" ? as_obj(mesh, false) : as_glb(asset));
        expect_near(bare, mesh, 1e-3f);
        EXPECT_THAT(bare.chart_periods, ElementsAre(glm::vec2(1, 0)));
        EXPECT_THAT(bare.warnings, IsEmpty());
    }
    // A corner of three faces of which one is twice as large and another split: angle × area of each counts once.
    const std::string corner =
        "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 0.5\nvt 0 0\nvt 1 0\nvt 0 1\n"
        "f 1/1 2/2 3/3\nf 1/1 3/2 4/3\nf 1/1 4/2 5/3\nf 1/1 5/2 2/3\n";
    const BaseMesh three = load("corner.obj", corner);
    // Towards z: area 1·(π/2); x: ½·(π/2); y: the two halves have the areas ½ each and angles atan 2 and π/2 − atan 2.
    const double right = std::numbers::pi / 2;
    const glm::vec3 wanted = glm::vec3(glm::normalize(glm::dvec3(0.5 * right, 0.5 * right, right)));
    EXPECT_LE(glm::distance(three.vertices[0].normal, wanted), 1e-6f);
}

TEST(MeshFile, WhatCannotBeDrawnIsCounted) {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvn 0 0 1\nvn 0 0 0\nvn 0.6 0 "
        "0.8\n"
        "f 1/1/1 2/2/2 3/3/1\n"
        "f 1/1/1 2/2/1 4/3/1\n"
        "f 1/1/1 2/2/1 2/3/1\n"
        "f 2/1/1 5/1/1 3/3/1\n"
        "f 2//1 4//1 5//1\n"
        "f 2/2/3 5/4/3 3/3/1\n";
    const BaseMesh mesh = load("poor.obj", text);
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.vertices.size(), 5U);
    EXPECT_EQ(mesh.vertices[1].normal, glm::vec3(0, 0, 1));
    EXPECT_THAT(mesh.warnings,
                ElementsAre(HasSubstr("1 triangle without texture coordinates"), HasSubstr("2 triangles of no area"),
                            HasSubstr("1 triangle whose texture coordinates span no area"),
                            HasSubstr("1 vertex normal of no length"), HasSubstr("1 side along which normals split")));
}

TEST(MeshFile, PrismsThatTurnInsideOutAreCounted) {
    const BaseMesh mesh = generate_base({.kind = BaseSource::Kind::sphere, .curvature = 4, .segments = 32});
    EXPECT_EQ(count_folded_prisms(mesh, 0.24), 0U);
    EXPECT_EQ(count_folded_prisms(mesh, 0.27), mesh.triangles.size());
    const BaseMesh saddle = generate_base({.kind = BaseSource::Kind::saddle, .curvature = 4, .segments = 32});
    EXPECT_EQ(count_folded_prisms(saddle, 0.24), 0U);
    const std::size_t folded = count_folded_prisms(saddle, 0.3);
    EXPECT_GT(folded, 0U);
    EXPECT_LT(folded, saddle.triangles.size());
    EXPECT_EQ(count_folded_prisms(generate_base({.kind = BaseSource::Kind::cylinder, .curvature = -3}), 0.5), 0U);
}

TEST(MeshFile, TextureCoordinatesBeyondOneAndQuantizedNumbersAreRead) {
    BaseMesh mesh = small_cylinder();
    for (MeshVertex& vertex : mesh.vertices)
        vertex.uv = vertex.uv * 8.0f - 3.0f;
    EXPECT_EQ(load("tiled.glb", as_glb(gltf_of(mesh))).vertices, mesh.vertices);
    EXPECT_THAT(load("tiled.obj", as_obj(mesh)).vertices[24].uv, glm::vec2(5, 5));

    // One triangle: positions as plain 16-bit integers, texture coordinates as parts of 255.
    GltfAsset asset{parse_json(R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_mesh_quantization"],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}],
        "bufferViews": [{"buffer": 0, "byteLength": 24, "byteStride": 8},
                        {"buffer": 0, "byteOffset": 24, "byteLength": 12, "byteStride": 4}],
        "accessors": [{"bufferView": 0, "componentType": 5122, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5121, "normalized": true, "count": 3, "type": "VEC2"}],
        "buffers": [{"byteLength": 36}]})",
                               "gltf"),
                    std::string("\0\0\0\0\0\0\0\0\xfe\xff\0\0\0\0\0\0\0\0\xfc\xff\0\0\0\0"
                                "\0\xff\0\0\xff\xff\0\0\0\0\0\0",
                                36)};
    const BaseMesh small = load("small.glb", as_glb(asset));
    ASSERT_EQ(small.vertices.size(), 3U);
    EXPECT_EQ(small.vertices[1].position, glm::vec3(-2, 0, 0));
    EXPECT_EQ(small.vertices[2].position, glm::vec3(0, -4, 0));
    EXPECT_EQ(small.vertices[1].uv, glm::vec2(1, 0));
    EXPECT_EQ(small.vertices[2].uv, glm::vec2(0, 1));
    EXPECT_EQ(small.vertices[0].normal, glm::vec3(0, 0, 1));
}

TEST(MeshFile, WhatIsWrongWithAnObjIsToldOnce) {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
    EXPECT_THAT(error_message([] { load_file_base({.kind = BaseSource::Kind::file, .file = "none.obj"}); }),
                HasSubstr("there is no mesh file 'none.obj'"));
    EXPECT_THAT(error_message([] { load_file_base({.kind = BaseSource::Kind::file, .file = folder.path()}); }),
                HasSubstr("is no file: give an OBJ or glTF 2.0 file"));
    EXPECT_THAT(complaint_about("mesh.fbx", "x"), HasSubstr("its name ends in '.fbx'; give an OBJ or glTF 2.0 file"));
    EXPECT_THAT(complaint_about("empty.obj", ""), HasSubstr("is empty"));
    EXPECT_THAT(complaint_about("none.obj", vertices), HasSubstr("has no triangles"));
    EXPECT_THAT(complaint_about("garbage.obj", "\x7f\x45LF\x01\x02 garbage"), HasSubstr("has no triangles"));
    EXPECT_THAT(complaint_about("nan.obj", "v 0 0 0\nv nan 0 0\n"), HasSubstr("nan.obj', line 2: 'nan' is no finite"));
    EXPECT_THAT(complaint_about("short.obj", "v 0 0 0\nv 1 0"), HasSubstr("line 2: 2 numbers, and 3 are needed"));
    EXPECT_THAT(complaint_about("large.obj", "v 1e99 0 0\n" + vertices + "f 1/1 2/2 3/3\n"), HasSubstr("not finite"));
    EXPECT_THAT(complaint_about("bare.obj", vertices + "f 1 2 3\n"), HasSubstr("has no texture coordinates"));
    EXPECT_THAT(complaint_about("index.obj", vertices + "f 1/1 2/2 4/3\n"), HasSubstr("the vertex 4, and there are 3"));
    EXPECT_THAT(complaint_about("uv.obj", vertices + "f 1/1 2/9 3/3\n"),
                HasSubstr("the texture coordinates 9, and there are 3"));
    EXPECT_THAT(complaint_about("normal.obj", vertices + "f 1/1/1 2/2/1 3/3/1\n"),
                HasSubstr("the normal 1, and there"));
    EXPECT_THAT(complaint_about("before.obj", vertices + "f -9/1 2/2 3/3\n"), HasSubstr("the vertex -5, and there"));
    EXPECT_THAT(complaint_about("quad.obj", vertices + "f 1/1 2/2 3/3 8/1\n"), HasSubstr("the vertex 8, and there"));
    EXPECT_THAT(complaint_about("thin.obj", vertices + "f 1/1 2/2 2/3\n"), HasSubstr("has an area"));
    EXPECT_THAT(complaint_about("point.obj", vertices + "f 1/1 2/1 3/1\n"), HasSubstr("span an area: unwrap"));
    EXPECT_THAT(complaint_about("far.obj", "vt 1e6 0\n" + vertices + "f 1/1 2/2 3/3\n"), HasSubstr("are read: export"));
    EXPECT_THAT(complaint_about("wide.obj", "v 1e7 0 0\n" + vertices + "f 1/1 2/2 4/3\n"), HasSubstr("base_fit=unit"));
    std::string polygon = vertices + "f";
    for (int corner = 0; corner < 1200; ++corner)
        polygon += " 1/1";
    EXPECT_THAT(complaint_about("polygon.obj", polygon + "\n"), HasSubstr("line 7: a polygon of 1200 corners"));
}

TEST(MeshFile, WhatIsWrongWithAGltfIsToldOnce) {
    const std::string whole = glb_with([](Json&) {});
    for (const std::size_t length : {5UL, 19UL, 200UL, whole.size() - 1})
        EXPECT_THAT(complaint_about("cut.glb", whole.substr(0, length)), HasSubstr("cut.glb' is cut short"));
    EXPECT_THAT(complaint_about("text.gltf", "{\"asset\": "), HasSubstr("text.gltf"));
    EXPECT_THAT(complaint_about("other.gltf", "[1]"), HasSubstr("is no glTF 2.0 file"));
    EXPECT_THAT(complaint_about("deep.gltf", std::string(100000, '[')), HasSubstr("nested more than 64 deep"));
    EXPECT_THAT(complaint_about("image.gltf", "\x89PNG\r\n"), HasSubstr("image.gltf"));
    struct Case {
        std::function<void(Json&)> change;
        const char* complaint;
    };
    const Case cases[] = {
        {[](Json& json) { json["asset"]["version"] = "1.0"; }, "is of version 1.0 of glTF"},
        {[](Json& json) { json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "needs the glTF extension KHR_draco_mesh_compression, which is not read: export it without compression"},
        {[](Json& json) { json["extensionsRequired"] = {"EXT_meshopt_compression"}; }, "without compression"},
        {[](Json& json) { json["extensionsRequired"] = {"KHR_texture_transform"}; }, "export it without it"},
        {[](Json& json) { json["meshes"][0]["primitives"][0]["mode"] = 1; }, "has no triangles"},
        {[](Json& json) { json["meshes"] = Json::array(); }, "there is no mesh 0 among its 0"},
        {[](Json& json) {
             json["scenes"] = Json::array({{{"nodes", Json::array()}}});
         },
         "has no triangles"},
        {[](Json& json) { json["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0"); },
         "has no texture coordinates"},
        {[](Json& json) { json["accessors"][0]["count"] = 26; }, "accessor 0, of positions, reaches beyond its buffer"},
        {[](Json& json) { json["accessors"][0]["count"] = 1ULL << 62U; }, "no more than 10000000 are read"},
        {[](Json& json) { json["accessors"][3]["count"] = 1ULL << 62U; }, "no more than 10000000 are read"},
        {[](Json& json) { json["accessors"][1]["byteOffset"] = 1ULL << 63U; }, "normals, reaches beyond its buffer"},
        {[](Json& json) { json["accessors"][0]["count"] = 20; }, "a triangle has the vertex"},
        {[](Json& json) { json["accessors"][2]["bufferView"] = 9; }, "there is no buffer view 9 among its 4"},
        {[](Json& json) { json["accessors"][2].erase("bufferView"); }, "there is no buffer view -1"},
        {[](Json& json) { json["accessors"][2]["componentType"] = 5125; }, "that texture coordinates can have"},
        {[](Json& json) { json["bufferViews"][0]["buffer"] = -1; }, "there is no buffer -1"},
        {[](Json& json) { json["bufferViews"][3]["byteLength"] = 1ULL << 63U; }, "indices, reaches beyond its buffer"},
        {[](Json& json) { json["buffers"][0]["byteLength"] = 1ULL << 40U; }, "in a binary chunk of"},
        {[](Json& json) { json["buffers"][0]["uri"] = "../nowhere.bin"; }, "there is no such file"},
        {[](Json& json) { json["buffers"][0]["uri"] = "/dev/zero"; }, "there is no such file"},
        {[](Json& json) { json["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA"; },
         "cannot read mesh"},
        {[](Json& json) { json["nodes"][0]["children"] = {0}; }, "node 0 has two parents"},
        {[](Json& json) {
             json["nodes"][0]["scale"] = {1, 2};
         },
         "a node's place"},
        {[](Json& json) {
             json["nodes"][0]["scale"] = {0, 0, 0};
         },
         "has an area"},
        {[](Json& json) {
             json["accessors"][0]["sparse"] = parse_json(R"({"count": 1,
            "indices": {"bufferView": 3, "componentType": 5125}, "values": {"bufferView": 0}})",
                                                         "sparse");
         },
         "stores its positions sparsely"},
    };
    for (const auto& [change, complaint] : cases)
        EXPECT_THAT(complaint_about("wrong.glb", glb_with(change)),
                    AllOf(HasSubstr("wrong.glb"), HasSubstr(complaint)));
    BaseMesh mesh = small_cylinder();
    mesh.vertices[3].position.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(complaint_about("nan.glb", as_glb(gltf_of(mesh))), HasSubstr("a position that is not finite"));
}

TEST(MeshFile, IsRefusedBeforeItTakesMoreMemoryThanThereIs) {
    setenv("RELIEFBENCH_MEMORY_MB", "1", 1);
    EXPECT_THAT(complaint_about("large.glb", as_glb(gltf_of(generate_base({.kind = BaseSource::Kind::sphere})))),
                AllOf(HasSubstr("to read, and 1 MB is available"), HasSubstr("simplify it")));
    // A thousand places for one mesh.
    EXPECT_THAT(complaint_about("often.glb", glb_with([](Json& json) {
                                    for (int node = 1; node < 1000; ++node) {
                                        json["nodes"].push_back({{"mesh", 0}});
                                        json["scenes"][0]["nodes"].push_back(node);
                                    }
                                })),
                HasSubstr("to read, and 1 MB is available"));
    unsetenv("RELIEFBENCH_MEMORY_MB");
}

}  // namespace
}  // namespace reliefbench
