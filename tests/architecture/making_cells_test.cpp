// Who constructs renderers and who sees that an allocation failed, told from the sources as text.

#include "source_tree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace reliefbench::test {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& code, const std::regex& pattern) {
    return std::regex_search(code, pattern);
}

std::string without_comments(const std::string& text) {
    static const std::regex comment("//[^\n]*");
    return std::regex_replace(text, comment, "");
}

/// Names of variables and members that hold renderers without being ones: an optional, a vector, a pointer.
std::set<std::string> holders_of_renderers(const std::string& code) {
    static const std::regex holder("<[^<>;]*\\bRenderer\\b[^<>;]*>+\\s+(\\w+)");
    if (code.find("Renderer") == std::string::npos) return {};
    const std::vector<std::string> names = matches(code, holder);
    return {names.begin(), names.end()};
}

/// One is put into a holder without being named.
bool fills_holder(const std::string& code, const std::set<std::string>& holders) {
    static const std::regex filled("\\b(\\w+)\\s*(?:(?:\\.|->)\\s*emplace(?:_back)?\\b|=\\s*\\{\\s*\\w)");
    const std::vector<std::string> names = matches(code, filled);
    return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return holders.contains(name); });
}

/// Whether a renderer is constructed, not one declared, handed on or returned. `holders`: of all files.
bool constructs_renderer(const std::string& code, const std::set<std::string>& holders) {
    static const std::regex made(
        // A variable; what has its first parameter's type in the parentheses, constant here, is a function's
        // declaration.
        "\\bRenderer\\s+\\w+\\s*\\(\\s*(?!const\\b)[\\w*&]|\\bRenderer\\s+\\w+\\s*(=\\s*)?\\{"
        // A temporary, on the heap or not.
        "|\\bRenderer\\s*[({]"
        // One in what holds it: make_unique<Renderer>(...), optional<Renderer> name{...}.
        "|\\bRenderer\\s*>\\s*(\\w+\\s*)?(\\(\\s*[\\w*&]|\\{\\s*[\\w*&])"
        // By another name.
        "|\\busing\\s+\\w+\\s*=\\s*[\\w:]*\\bRenderer\\s*;|\\btypedef\\s+[\\w:]*\\bRenderer\\b");
    static const std::regex returning_function("\\bRenderer\\s+(\\w+::)*\\w+\\([^;{}]*\\)[^;{}]*\\{");
    static const std::regex returned_braces("\\breturn\\s*\\{");
    if (fills_holder(code, holders)) return true;
    if (code.find("Renderer") == std::string::npos) return false;
    return has(code, made) || (has(code, returning_function) && has(code, returned_braces));
}

/// Whether a handler takes a failed allocation, alone or among all there is.
bool catches_allocation(const std::string& code) {
    static const std::regex handler(
        "\\bcatch\\s*\\(\\s*(\\.\\.\\.|[^)]*\\b(bad_alloc|bad_array_new_length|std\\s*::\\s*exception|"
        "OutOf(Host|Device)MemoryError)\\b)");
    return code.find("catch") != std::string::npos && has(code, handler);
}

TEST(MakingCells, EveryWayToConstructARendererIsSeen) {
    const std::string held = "std::optional<Renderer> kept = {};\nstd::vector<Renderer> drawn;\n";
    const std::set<std::string> holders = holders_of_renderers(held);
    EXPECT_EQ(holders, (std::set<std::string>{"kept", "drawn"}));
    for (const char* code :
         {"Renderer renderer(device, technique, parameters);", "Renderer renderer(\n    inputs_.device());",
          "Renderer renderer{device};", "Renderer renderer = {device, technique};", "draw(Renderer(device));",
          "auto renderer = Renderer{device};", "auto* renderer = new Renderer(device);",
          "auto renderer = std::make_unique<Renderer>(device);", "std::make_shared<Renderer>(*device)",
          "std::optional<Renderer> mine(device, technique);", "std::optional<Renderer> mine{std::in_place, device};",
          "std::make_optional<Renderer>(device)", "cell.kept.emplace(device);", "cell->kept = {device, technique};",
          "drawn.emplace_back(device);", "using Drawer = Renderer;", "typedef technique::Renderer Drawer;",
          "Renderer made(const Device& device) { return {device, technique}; }"})
        EXPECT_TRUE(constructs_renderer(code, holders)) << code;
    for (const char* code :
         {"Renderer make_renderer(const gpu::Device& device, const Technique& technique);",
          "Renderer renderer = list.make_renderer(parameters);", "void warm_up(std::size_t index, Renderer renderer);",
          "Renderer& renderer() { return renderer_; }", "Renderer* renderer = nullptr;",
          "cell.kept = std::move(other);", "std::optional<Renderer> kept = {};", "std::optional<Renderer> kept;"})
        EXPECT_FALSE(constructs_renderer(code, holders)) << code;
}

TEST(MakingCells, EveryHandlerThatTakesAFailedAllocationIsSeen) {
    for (const char* code :
         {"catch (const std::bad_alloc&) {", "catch (std::bad_alloc& failure)", "catch(...)", "catch ( ... ) {",
          "catch (const std::exception& error) {", "catch (std::exception const& error)",
          "catch (const std::bad_array_new_length&)", "catch (const vk::OutOfDeviceMemoryError&)"})
        EXPECT_TRUE(catches_allocation(code)) << code;
    for (const char* code :
         {"catch (const Error& error) {", "catch (const Json::exception& error)", "catch (const vk::SystemError&)"})
        EXPECT_FALSE(catches_allocation(code)) << code;
}

TEST(Architecture, CellsAreMadeReadyInOnePlace) {
    std::map<std::string, std::string> code_by_name;
    std::set<std::string> holders;
    for (const fs::path& file : files_below(source_root / "harness", {".hpp", ".cpp"})) {
        std::string code = without_comments(read(file));
        holders.merge(holders_of_renderers(code));
        code_by_name[fs::relative(file, source_root / "harness").generic_string()] = std::move(code);
    }
    std::set<std::string> makers;
    std::set<std::string> catchers;
    for (const auto& [name, code] : code_by_name) {
        if (!name.starts_with("technique/") && constructs_renderer(code, holders)) makers.insert(name);
        if (catches_allocation(code)) catchers.insert(name);
    }
    // Checks draw what is no cell of any configuration, and take the verdict from technique/draw_verdict.hpp alike.
    EXPECT_EQ(makers, (std::set<std::string>{"measure/laboratory.cpp", "verify/drawing.cpp"}));
    const std::set<std::string> expected_catchers = {
        "core/attempt.cpp",
        // Ends the program.
        "cli/main.cpp",
        // The compiler's child process tells its parent; glslang, which calls its includer, must not be thrown through.
        "core/limited_child.cpp", "gpu/shader_compiler.cpp",
        // Thrown again: after the other threads, without the part of a file, with what Vulkan says.
        "core/parallel.cpp", "core/file.cpp", "gpu/handles.hpp",
        // Before or beside all cells: a folder that is no technique, maps that are not kept for the next run.
        "technique/technique.cpp", "core/cache_folder.cpp"};
    EXPECT_EQ(catchers, expected_catchers);
}

}  // namespace
}  // namespace reliefbench::test
