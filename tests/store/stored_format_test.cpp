#include "store/stored_format.hpp"

#include "store/run_folder.hpp"
#include "support/error_message.hpp"

#include <gmock/gmock.h>

namespace reliefbench {
namespace {

int format_of_record(const Json& record) {
    return format_of(JsonView(record, "run.json"));
}

TEST(StoredFormat, IsOneWhereTheRecordHasNone) {
    EXPECT_EQ(format_of_record(Json::object()), 1);
    EXPECT_EQ(format_of_record({{"format", 2}}), 2);
}

TEST(StoredFormat, OfALaterVersionIsAnErrorThatSaysWhatToDo) {
    EXPECT_EQ(error_message([] {
                  format_of_record({{"format", stored_run_format + 1}});
              }),
              "run.json: $.format: a later version of reliefbench wrote this run: it has format 3, and this version "
              "reads formats up to 2; use a version that is not older than the run");
    EXPECT_THAT(error_message([] { format_of_record({{"format", 0}}); }), testing::HasSubstr("expected an integer"));
}

CellResult cell_of(const std::string& id, const Json& parameters) {
    CellResult cell;
    cell.cell = id;
    cell.technique = id.substr(0, id.find(' '));
    cell.parameters = parameters;
    return cell;
}

TEST(StoredFormat, DefaultsThatNoRecordHasAreThoseThatIdsLeaveOut) {
    const reliefbench::Run run{
        .run = Json::object(),
        .cells = {cell_of("pom max_steps=16 | heightmap=a leaf=1", {{"max_steps", 16}, {"min_steps", 8}, {"leaf", 4}}),
                  cell_of("pom min_steps=4 | heightmap=a", {{"max_steps", 50}, {"min_steps", 4}, {"leaf", 4}}),
                  cell_of("flat | heightmap=a", Json::object())}};
    EXPECT_EQ(defaults_of(run).at("parameters"),
              Json::parse(R"({"pom": {"min_steps": 8, "leaf": 4, "max_steps": 50}, "flat": {}})"));
}

TEST(StoredFormat, RecordedDefaultsCount) {
    const Json defaults = Json::parse(R"({"parameters": {"pom": {"max_steps": 20}}, "axes": {"fov": 45}})");
    const reliefbench::Run run{.run = {{"defaults", defaults}},
                               .cells = {cell_of("pom | heightmap=a", {{"max_steps", 50}})}};
    EXPECT_EQ(defaults_of(run), defaults);
}

}  // namespace
}  // namespace reliefbench
