#include "configuration_text.hpp"
#include "core/file.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace reliefbench {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// A folder of its own with height map files (nothing reads them here), and a working directory beside it.
class ConfigurationFiles : public testing::Test {
protected:
    ConfigurationFiles() : before_(fs::current_path()) {
        for (const char* folder : {"configs/maps", "here", "other"})
            fs::create_directories(root_ / folder);
        for (const char* file : {"configs/here.png", "configs/both.png", "configs/maps/deep.png", "here/both.png",
                                 "here/there.png", "other/both.png", "here/skin.jpg"}) {
            write_text_file(root_ / file, "not read");
        }
        fs::current_path(root_ / "here");
    }
    ~ConfigurationFiles() override { fs::current_path(before_); }

    Configuration read(const std::string& heightmap, const std::vector<std::string>& overrides = {}) {
        const std::string text = with(R"("axes": {"heightmap": )" + heightmap + "}", R"(["plain"])");
        write_text_file(root_ / "configs" / "test.json", text);
        const std::filesystem::path file = root_ / "configs" / "test.json";
        return parse_configuration(read_json_file(file), file.string(), overrides, fake_techniques());
    }
    std::string source(const Configuration& configuration) {
        return expand(configuration, fake_techniques()).front().view.height_map.name;
    }

    const fs::path before_;
    const TemporaryFolder root_;
};

TEST_F(ConfigurationFiles, AreSoughtBesideTheConfigurationThenInTheWorkingDirectory) {
    EXPECT_EQ(source(read(R"("here.png")")), (root_ / "configs/here.png").string());
    EXPECT_EQ(source(read(R"("maps/deep.png")")), (root_ / "configs/maps/deep.png").string());
    EXPECT_EQ(source(read(R"("both.png")")), (root_ / "configs/both.png").string());
    EXPECT_EQ(source(read(R"("there.png")")), (root_ / "here/there.png").string());
    EXPECT_EQ(source(read(R"({"file": "../here/both.png"})")), (root_ / "here/both.png").string());
    EXPECT_THROW(read(R"("nowhere.png")"), Error);
}

TEST_F(ConfigurationFiles, OfOverridesAreSoughtInTheWorkingDirectory) {
    EXPECT_EQ(source(read(R"("rock")", {"heightmap=both.png"})), (root_ / "here/both.png").string());
    EXPECT_THROW(read(R"("rock")", {"heightmap=here.png"}), Error);
}

TEST_F(ConfigurationFiles, AreCalledByTheirBaseNameAndHowTheyAreRead) {
    const Configuration configuration = read(R"(["there.png", {"file": "there.png", "channel": 2, "invert": true},
        {"file": "there.png", "normalize": true}, {"file": "there.png", "height_range": [0.1, 2], "albedo": "skin.jpg"}])");
    EXPECT_THAT(ids(configuration),
                ElementsAre("plain | heightmap=there.png", "plain | heightmap=there.png+channel=2+invert",
                            "plain | heightmap=there.png+normalize",
                            "plain | heightmap=there.png+height_range=0.1:2+albedo=skin.jpg"));
    const std::vector<Cell> cells = expand(configuration, fake_techniques());
    EXPECT_TRUE(cells[1].view.height_map.invert);
    EXPECT_EQ(cells[1].view.height_map.channel, "2");
    EXPECT_EQ(cells[3].view.height_map.albedo, (root_ / "here/skin.jpg").string());
    EXPECT_EQ(axes_to_json(cells[0].view)["heightmap_size"], Json());
    // Asked for by base name, all readings of the file answer.
    EXPECT_EQ(filter_cells(cells, {"heightmap=there.png"}, fake_techniques()).size(), 4U);
    EXPECT_EQ(filter_cells(cells, {"heightmap=there.png+normalize"}, fake_techniques()).size(), 1U);
    EXPECT_EQ(read(configuration.expanded["axes"]["heightmap"].dump()).expanded, configuration.expanded);
}

TEST_F(ConfigurationFiles, SayHowTheyAreRead) {
    const Configuration configuration = read(R"([
        {"file": "there.png", "part": "height", "channel": "Z"}, {"file": "there.png", "part": 1, "channel": 0},
        {"file": "there.png", "packing": "rg16", "nodata": -32768, "fill": 0.5},
        {"file": "there.png", "size": "8x4", "sample_type": "int16", "byte_order": "big"},
        {"file": "there.png", "size": 4}])");
    EXPECT_THAT(ids(configuration),
                ElementsAre("plain | heightmap=there.png+part=height+channel=Z", "plain | heightmap=there.png+part=1",
                            "plain | heightmap=there.png+packing=rg16+nodata=-32768+fill=0.5",
                            "plain | heightmap=there.png+size=8x4+sample_type=int16+byte_order=big",
                            "plain | heightmap=there.png+size=4x4"));
    const std::vector<Cell> cells = expand(configuration, fake_techniques());
    EXPECT_EQ(cells[2].view.height_map.packing, Packing::rg16);
    ASSERT_TRUE(cells[3].view.height_map.raw);
    EXPECT_EQ(*cells[3].view.height_map.raw,
              (RawLayout{.size = {8, 4}, .sample_type = RawLayout::SampleType::int16, .big_endian = true}));
    EXPECT_EQ(cells[3].view.height_map.size, HeightMapSource{}.size);
    EXPECT_EQ(read(configuration.expanded["axes"]["heightmap"].dump()).expanded, configuration.expanded);
}

TEST_F(ConfigurationFiles, TakeNoCopyPerHeightMapSize) {
    EXPECT_THAT(ids(read(R"(["there.png", "rock"])", {"heightmap_size=64,128"})),
                ElementsAre("plain | heightmap=there.png", "plain | heightmap=rock heightmap_size=64x64",
                            "plain | heightmap=rock heightmap_size=128x128"));
}

TEST_F(ConfigurationFiles, OfOneBaseNameCannotBeToldApart) {
    EXPECT_THAT(error_message([&] { ids(read(R"(["both.png", "../other/both.png"])")); }),
                AllOf(HasSubstr("configs/both.png"), HasSubstr("other/both.png"), HasSubstr("rename")));
}

TEST_F(ConfigurationFiles, OfAlbedosAreAnAxisAndPartOfTheMapsName) {
    const std::string own = R"({"name": "rock", "albedo": "both.png"})";
    const auto albedo = [&](const std::string& heightmap, const std::vector<std::string>& overrides) {
        return expand(read(heightmap, overrides), fake_techniques()).front().view.height_map.albedo;
    };
    const auto names = [](const std::vector<Cell>& cells) {
        std::vector<std::string> found;
        for (const Cell& cell : cells)
            found.push_back(cell.id);
        return found;
    };
    EXPECT_EQ(albedo(R"("rock")", {"albedo=skin.jpg"}), (root_ / "here/skin.jpg").string());
    EXPECT_EQ(albedo(own, {}), (root_ / "configs/both.png").string());
    EXPECT_EQ(albedo(own, {"albedo=skin.jpg"}), (root_ / "here/skin.jpg").string()) << "what is asked for last";
    EXPECT_EQ(albedo(own, {"albedo=none"}), "");
    for (const auto& both : {std::vector<std::string>{"albedo=none", "heightmap=" + own},
                             std::vector<std::string>{"heightmap=" + own, "albedo=none"}})
        EXPECT_THAT(error_message([&] { read(R"("rock")", both); }), HasSubstr("give either that or the axis albedo"));
    const std::vector<Cell> cells =
        expand(read(R"(["rock", "both.png"])", {"albedo=none,skin.jpg"}), fake_techniques());
    EXPECT_THAT(names(cells), ElementsAre("plain | heightmap=rock", "plain | heightmap=rock+albedo=skin.jpg",
                                          "plain | heightmap=both.png", "plain | heightmap=both.png+albedo=skin.jpg"));
    EXPECT_THAT(names(filter_cells(cells, {"albedo=skin.jpg", "heightmap=rock"}, fake_techniques())),
                ElementsAre("plain | heightmap=rock+albedo=skin.jpg"));
    EXPECT_FALSE(axes_to_json(cells[1].view).contains("albedo"));
    EXPECT_THAT(error_message([&] { read(R"("rock")", {"albedo=gone.png"}); }),
                AllOf(HasSubstr("-a albedo=gone.png"), HasSubstr("no file 'gone.png'")));
}

TEST_F(ConfigurationFiles, OfAPipeAreTakenFromTheWorkingDirectory) {
    const Json json = parse_json(with(R"("axes": {"heightmap": "both.png"})", R"(["plain"])"), "test");
    for (const char* file : {"standard input", "/dev/stdin", "/dev/fd/63", "/proc/self/fd/0"}) {
        const Configuration configuration = parse_configuration(json, file, {}, fake_techniques());
        EXPECT_EQ(source(configuration), (root_ / "here/both.png").string()) << file;
        EXPECT_EQ(configuration.name, "configuration") << file;
    }
}

TEST_F(ConfigurationFiles, WithCommasAndBracketsAreWrittenAsJson) {
    const std::string name = "sp ace, [x]=d|\u00e9<i>.png";
    write_text_file(root_ / "here" / name, "not read");
    const std::string quoted = "[" + Json(name).dump() + "]";
    const Configuration configuration = read(R"("rock")", {"heightmap=" + quoted});
    EXPECT_EQ(source(configuration), (root_ / "here" / name).string());
    const std::vector<Cell> cells = expand(configuration, fake_techniques());
    EXPECT_EQ(filter_cells(cells, {"heightmap=" + quoted}, fake_techniques()).size(), 1U);
    EXPECT_EQ(filter_cells(cells, {"heightmap=rock," + quoted}, fake_techniques()).size(), 1U);
    EXPECT_THAT(error_message([&] { filter_cells(cells, {"heightmap!=" + quoted}, fake_techniques()); }),
                HasSubstr("no cell"));
}

}  // namespace
}  // namespace reliefbench
