#include "verify_test.hpp"

#include "core/file.hpp"
#include "manifest/shared_shaders.hpp"

namespace reliefbench::test {

namespace {

namespace fs = std::filesystem;

struct StopAtFailure {};

/// Exactly one place, or the test that asks for it fails.
void replace_once(const fs::path& file, const std::string& passage, const std::string& replacement) {
    std::string text = read_text_file(file);
    const std::size_t place = text.find(passage);
    ASSERT_NE(place, std::string::npos) << file << " has no passage '" << passage << "'";
    ASSERT_EQ(text.find(passage, place + 1), std::string::npos) << file << " has '" << passage << "' twice";
    text.replace(place, passage.size(), replacement);
    write_text_file(file, text);
}

}  // namespace

void VerifyTest::SetUpTestSuite() {
    if (!shared_device())
        shared_device() = std::make_unique<gpu::Device>(gpu::DeviceOptions{.choice = "", .validation = true});
}

void VerifyTest::TearDown() {
    const std::vector<std::string> messages = device().validation_messages();
    for (std::size_t i = messages_before_; i < messages.size(); ++i)
        ADD_FAILURE() << messages[i];
}

std::unique_ptr<gpu::Device>& VerifyTest::shared_device() {
    static std::unique_ptr<gpu::Device> device;
    return device;
}

TruthComparison VerifyTest::compare(const std::string& technique, const ParameterValues& changed,
                                    const CoordinateScene& scene, const View& view) {
    const Technique subject = shipped(technique);
    return compare_with_truth(device(), subject, with_values(subject.manifest, changed), scene, view);
}

Technique shipped(const std::string& id) {
    return find_techniques({default_technique_root()}).get(id);
}

std::vector<std::string> shipped_ids() {
    std::vector<std::string> ids;
    for (const Technique& technique : find_techniques({default_technique_root()}).techniques)
        ids.push_back(technique.manifest.id);
    return ids;
}

View parallel_view(double angle, double azimuth) {
    View view;
    view.camera.projection = Projection::parallel;
    view.camera.view_angle = angle;
    view.camera.azimuth = azimuth;
    view.relief.height_scale = 0.1;
    view.resolution = {96, 96};
    return view;
}

View perspective_view(double angle, double azimuth) {
    View view = parallel_view(angle, azimuth);
    view.camera.projection = Projection::perspective;
    return view;
}

HeightMap procedural(const std::string& name, Resolution size) {
    HeightMapSource source;
    source.name = name;
    source.size = size;
    return load_height_map(source, HeightFormat::r16);
}

HeightMap map_of(Resolution size, const std::function<double(int x, int y)>& height) {
    Image<float> heights(size);
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            heights.at(x, y) = static_cast<float>(height(x, y));
    }
    return make_height_map(heights, HeightFormat::r16, "made");
}

BrokenCopy::BrokenCopy(const std::string& id, const std::vector<Replacement>& replacements) {
    const fs::path folder = root_ / "techniques" / id;
    const fs::path shaders = root_ / "shaders";
    fs::create_directories(folder);
    fs::copy(default_technique_root() / id, folder, fs::copy_options::recursive);
    fs::copy(shader_root(), shaders, fs::copy_options::recursive);
    for (const auto& [file, passage, replacement] : replacements)
        replace_once(fs::exists(folder / file) ? folder / file : find_shared_file(shaders, file), passage, replacement);
    technique_ = find_techniques({folder.parent_path()}, shaders).get(id);
}

std::vector<Check> checks_until_failure(const gpu::Device& device, const Technique& technique,
                                        const std::function<void(CheckList&)>& body) {
    std::vector<Check> checks;
    CheckList list(device, technique, [&](const Check& check) {
        checks.push_back(check);
        if (!check.passed) throw StopAtFailure{};
    });
    try {
        body(list);
    } catch (const StopAtFailure&) {
    }
    return checks;
}

}  // namespace reliefbench::test
