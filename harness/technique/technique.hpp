#pragma once

#include "manifest/manifest.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace reliefbench {

/// techniques/, harness/shaders/ and configs/ of RELIEFBENCH_DATA_DIR; where that is not set, of this binary's folder
/// or the one above (an unpacked archive), or of share/reliefbench beside bin/ (an installation); else of the sources
/// that built it.
std::filesystem::path default_technique_root();
std::filesystem::path shader_root();
std::filesystem::path configuration_root();

/// A technique as found: its folder is the unit, the folder's name its id.
struct Technique {
    Manifest manifest;
    std::filesystem::path folder;
    /// Content hash of what its compilations include of the folder (technique/source_identity.hpp).
    std::string hash;
    /// Of the GLSL that it is compiled with.
    std::filesystem::path shaders = shader_root();
};

struct TechniqueLibrary {
    /// Sorted by id.
    std::vector<Technique> techniques;
    /// Folders whose technique.json cannot be used: id and message. Naming one in a configuration is an Error with it.
    std::vector<std::pair<std::string, std::string>> broken;

    std::vector<Manifest> manifests() const;
    /// Throws Error with the reason for a broken one, or with "did you mean" for an unknown one.
    const Technique& get(const std::string& id) const;
};

/// What is made of an id that two folders have.
enum class SameId {
    /// One of the first root, which has the shipped ones, gives way to another; two of other roots are an Error.
    first_root_gives_way,
    /// That of the later root takes the other's place.
    last_wins,
};

/// Every sub-folder of `roots` with a technique.json; one that two roots lead to, by whatever path or link, counts
/// once.
TechniqueLibrary find_techniques(const std::vector<std::filesystem::path>& roots,
                                 const std::filesystem::path& shaders = shader_root(),
                                 SameId same_id = SameId::first_root_gives_way);

/// Whether it has the id of a shipped one and is another.
bool takes_place_of_shipped(const Technique& technique);

/// Why a folder is no root: it is a technique's own folder, or there is no technique in it. Empty where it is one, and
/// where there is no folder at all.
std::string complaint_of_root(const std::filesystem::path& root);

}  // namespace reliefbench
