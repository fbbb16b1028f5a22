#include "verify_test.hpp"

#include "core/file.hpp"

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

std::string include_of(const std::string& file) {
    return "#include \"" + file + "\"";
}

/// A copy of a file of harness/shaders in `folder`, under another name, which trace.glsl includes in its place,
/// directly or through a copy of the shared file that does. Returns the copy's name.
std::string copy_shared_file(const fs::path& folder, const std::string& file) {
    const std::string copy = "broken_" + file;
    fs::copy_file(shader_root() / file, folder / copy);
    std::string includer = "trace.glsl";
    if (read_text_file(folder / includer).find(include_of(file)) == std::string::npos) {
        for (const auto& entry : fs::directory_iterator(shader_root())) {
            const std::string shared = entry.path().filename().string();
            const bool includes = read_text_file(entry.path()).find(include_of(file)) != std::string::npos;
            if (includes && read_text_file(folder / includer).find(include_of(shared)) != std::string::npos) {
                includer = copy_shared_file(folder, shared);
                break;
            }
        }
    }
    replace_once(folder / includer, include_of(file), include_of(copy));
    return copy;
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

Comparison VerifyTest::compare(const std::string& technique, const ParameterValues& changed,
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

BrokenCopy::BrokenCopy(const std::string& id, const std::string& file, const std::string& passage,
                       const std::string& replacement) {
    const fs::path folder = root_ / id;
    fs::copy(default_technique_root() / id, folder, fs::copy_options::recursive);
    const std::string broken_file = fs::exists(folder / file) ? file : copy_shared_file(folder, file);
    replace_once(folder / broken_file, passage, replacement);
    technique_ = find_techniques({root_.path()}).get(id);
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
