#pragma once

#include "measure/truth_cache.hpp"
#include "metrics/truth_noise.hpp"
#include "reference/truth.hpp"
#include "scene/albedo.hpp"
#include "scene/height_map.hpp"
#include "sweep/configuration.hpp"
#include "technique/renderer.hpp"

#include <filesystem>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <vector>

namespace reliefbench {

/// What a run remembers of an input once its pixels are dropped.
struct HeightMapRecord {
    HeightMapSource source;
    HeightFormat format = HeightFormat::r16;
    std::string name = {};
    Resolution size = {};
    std::string hash = {};
    std::string albedo_hash = {};
    std::string mapping = {};
    bool constant = false;
};

/// Loads every height map and albedo of the cells once, so that a bad one is an Error before anything is written. One
/// that the memory does not hold is a warning, and has no hashes: its cells are skipped, or fail. `on_map`, unless
/// empty, is told each map before it is loaded.
std::vector<HeightMapRecord> inspect_height_maps(const std::vector<Cell>& cells,
                                                 const std::function<void(const std::string& map)>& on_map = {});

/// The same Errors and warnings for what is read from files, without the records.
void check_input_files(const std::vector<Cell>& cells);

/// A height map loaded and on the device.
struct LoadedMap {
    LoadedMap(const gpu::Device& device, const HeightMapSource& source, HeightFormat format);

    HeightMap map;
    Albedo albedo;
    /// content_of(albedo)
    std::string albedo_content;
    SceneOnDevice scene;
};

Truth trace_truth(const LoadedMap& loaded, const View& view, const Lighting& lighting, const TruthSettings& settings,
                  const std::optional<SceneObject>& object = std::nullopt);

/// Height maps and truths that the cells of a block share. Truths come from the cache folder `cache` where it has them,
/// and go there (measure/truth_cache.hpp); empty: nowhere. Holds one truth, that of the view asked for last: cells of
/// one view are neighbours, so that each view is traced once.
class SharedInputs {
public:
    SharedInputs(const gpu::Device& device, const Lighting& lighting, const TruthSettings& settings,
                 const std::optional<SceneObject>& object = std::nullopt, std::filesystem::path cache = {});

    const gpu::Device& device() const { return *device_; }

    /// An Error where there is not the memory for it.
    const LoadedMap& map(const ViewKey& key);
    /// The view with its base surface, loaded or generated once for all views that have it.
    View view(const ViewKey& key);
    bool has_map(const ViewKey& key) const;
    bool has_truth(const ViewKey& view) const;
    /// Valid until the truth of another view is asked for.
    const Truth& truth(const ViewKey& view);
    /// That of truth(view), which may be traced for it; empty with one sample a pixel.
    const std::optional<TruthNoise>& noise(const ViewKey& view);
    /// The same view's from another camera, which is not kept, without shadows and with a picture of one sample: what
    /// is in motion are hits.
    Truth truth_from(const ViewKey& key, const Camera& camera);
    /// Frees what none of these views needs.
    void keep_only(const std::vector<ViewKey>& views);

    /// Of all truths so far.
    const TruthWork& truths() const { return truths_; }

private:
    struct KeyedMap {
        HeightMapSource source;
        HeightFormat format;
        LoadedMap loaded;
    };
    struct KeyedBase {
        BaseSource source;
        BaseSurface loaded;
    };
    struct KeyedTruth {
        ViewKey key;
        Truth truth;
        std::optional<TruthNoise> noise;
    };

    Truth trace(const ViewKey& key, const View& view, const TruthSettings& settings);

    const gpu::Device* device_;
    Lighting lighting_;
    TruthSettings settings_;
    std::optional<SceneObject> object_;
    std::filesystem::path cache_;
    std::list<KeyedMap> maps_;
    std::list<KeyedBase> bases_;
    std::optional<KeyedTruth> truth_;
    TruthWork truths_;
};

}  // namespace reliefbench
