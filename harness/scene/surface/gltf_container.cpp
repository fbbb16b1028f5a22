#include "scene/surface/gltf_container.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "scene/surface/mesh_file.hpp"

#include <array>
#include <cstdint>
#include <string_view>

namespace reliefbench {

namespace {

/// What of a file has to do with triangles: tinygltf does not get to see the rest, whose readers trust what they read.
constexpr std::array<const char*, 8> geometry_members{"asset",  "scene",     "scenes",      "nodes",
                                                      "meshes", "accessors", "bufferViews", "buffers"};

/// What a file may need and is read all the same: more types of numbers, and what concerns materials and lights alone.
bool is_understood_extension(const std::string& name) {
    for (const std::string_view prefix : {"KHR_materials_", "KHR_lights_", "EXT_texture_", "KHR_texture_basisu"}) {
        if (name.starts_with(prefix)) return true;
    }
    return name == "KHR_mesh_quantization";
}

bool is_compression(const std::string& name) {
    return name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression" ||
           name == "KHR_meshopt_compression";
}

/// The buffer without a "uri" is the binary chunk of a .glb.
constexpr const char* name_of_chunk = "binary-chunk";

/// A .glb's JSON and binary chunk, or a .gltf as it is.
struct Chunks {
    std::string_view json;
    std::string_view binary;
};

std::uint32_t little_endian(std::string_view bytes, std::size_t place) {
    std::uint32_t number = 0;
    for (std::size_t byte = 4; byte-- > 0;)
        number = number << 8u | static_cast<unsigned char>(bytes[place + byte]);
    return number;
}

Chunks find_chunks(const std::filesystem::path& path, std::string_view bytes) {
    constexpr std::size_t header = 12;
    constexpr std::size_t chunk_header = 8;
    constexpr std::uint32_t json_type = 0x4E4F534A;
    constexpr std::uint32_t binary_type = 0x004E4942;
    if (!bytes.starts_with("glTF")) return {bytes, {}};
    const auto fail_cut_short = [&] { fail("mesh '{}' is cut short: fetch or export it again", path.string()); };
    if (bytes.size() < header + chunk_header) fail_cut_short();
    if (const std::uint32_t version = little_endian(bytes, 4); version != 2) {
        fail("mesh '{}' is of version {} of glTF: export it as glTF 2.0", path.string(), version);
    }
    const std::uint32_t length = little_endian(bytes, 8);
    if (length > bytes.size()) fail_cut_short();
    bytes = bytes.substr(0, length);
    Chunks chunks;
    std::size_t place = header;
    for (int chunk = 0; place + chunk_header <= bytes.size(); ++chunk) {
        const std::uint32_t size = little_endian(bytes, place);
        const std::uint32_t type = little_endian(bytes, place + 4);
        place += chunk_header;
        if (size > bytes.size() - place) fail_cut_short();
        if (chunk == 0 && type == json_type) chunks.json = bytes.substr(place, size);
        if (chunk == 1 && type == binary_type) chunks.binary = bytes.substr(place, size);
        place += size;
    }
    if (chunks.json.empty()) fail("mesh '{}' has no JSON chunk first, and is no glTF 2.0 file", path.string());
    return chunks;
}

void check_extensions(const std::filesystem::path& path, const Json& gltf) {
    const auto required = gltf.find("extensionsRequired");
    if (required == gltf.end() || !required->is_array()) return;
    for (const Json& name : *required) {
        if (!name.is_string() || is_understood_extension(name)) continue;
        fail("mesh '{}' needs the glTF extension {}, which is not read: export it without {}", path.string(),
             name.get<std::string>(), is_compression(name) ? "compression" : "it");
    }
}

/// Those members, with a name for the binary chunk.
std::string geometry_of(const Json& gltf, GltfContainer& container) {
    const std::string path = container.path.string();
    const std::size_t chunk_size = container.chunk_length;
    Json geometry = Json::object();
    for (const char* member : geometry_members) {
        if (const auto found = gltf.find(member); found != gltf.end()) geometry[member] = *found;
    }
    const auto listed = geometry.find("buffers");
    if (listed == geometry.end() || !listed->is_array()) fail("mesh '{}' has no buffers", path);
    for (Json& buffer : *listed) {
        if (!buffer.is_object() || buffer.contains("uri")) continue;
        const Json length = buffer.value("byteLength", Json());
        if (&buffer != &listed->front() || !length.is_number_unsigned() || chunk_size == 0) {
            fail("mesh '{}' has a buffer without content: export it with its buffers, as a .glb", path);
        }
        container.chunk_length = length.get<std::size_t>();
        if (container.chunk_length > chunk_size) {
            fail("mesh '{}' has a buffer of {} bytes in a binary chunk of {}: it is damaged", path,
                 container.chunk_length, chunk_size);
        }
        buffer["uri"] = name_of_chunk;
    }
    return geometry.dump();
}

}  // namespace

GltfContainer open_gltf(const std::filesystem::path& path) {
    GltfContainer container{.path = path, .bytes = read_text_file(path, max_mesh_file_bytes), .geometry = {}};
    check_mesh_size(path, 3 * container.bytes.size(), 0);
    const Chunks chunks = find_chunks(path, container.bytes);
    if (!chunks.binary.empty())
        container.chunk_begin = static_cast<std::size_t>(chunks.binary.data() - container.bytes.data());
    container.chunk_length = chunks.binary.size();
    const Json gltf = parse_json(chunks.json, path.string());
    if (!gltf.is_object() || !gltf.contains("asset"))
        fail("mesh '{}' is no glTF 2.0 file: it has no \"asset\"", path.string());
    check_extensions(path, gltf);
    container.geometry = geometry_of(gltf, container);
    return container;
}

std::vector<unsigned char> gltf_buffer(const GltfContainer& container, const std::string& name) {
    if (name == name_of_chunk) {
        const std::string_view chunk =
            std::string_view(container.bytes).substr(container.chunk_begin, container.chunk_length);
        return {chunk.begin(), chunk.end()};
    }
    const std::filesystem::path file = container.path.parent_path() / name;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) fail("there is no such file");
    const std::string content = read_text_file(file, max_mesh_file_bytes);
    return {content.begin(), content.end()};
}

}  // namespace reliefbench
