#include "verify_test.hpp"

#include "verify/conformance.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <tuple>

namespace reliefbench::test {

namespace {

/// Promise, "name=value" of the parameters under which it holds, halvings parameter.
using PromiseText = std::tuple<std::string, std::string, std::string>;

std::set<PromiseText> promises_of(const Manifest& manifest) {
    std::set<PromiseText> promises;
    for (const PromiseDeclaration& declaration : manifest.promises) {
        std::string with;
        for (const auto& [name, value] : declaration.with)
            with += (with.empty() ? "" : " ") + name + "=" + to_string(value);
        promises.insert({to_string(declaration.promise), with, declaration.halvings.value_or("")});
    }
    return promises;
}

class ShippedTechnique : public VerifyTest, public testing::WithParamInterface<std::string> {};

}  // namespace

/// All that any makes: a technique that is not here makes none.
TEST(Promises, ShippedTechniquesMakeThese) {
    const std::map<std::string, std::set<PromiseText>> expected{
        {"steep", {{"order_1", "adaptive=false", ""}}},
        {"relief", {{"order_1", "adaptive=false", "binary_steps"}}},
        {"pom", {{"order_2", "adaptive=false", ""}}},
        {"contact_refinement",
         {{"order_1", "adaptive=false refinement_steps=2", "refinements"}, {"order_2", "adaptive=false", ""}}},
        {"max_mip", {{"first_hit", "", ""}, {"conservative", "", ""}}},
        {"qdm",
         {{"first_hit", "leaf=exact", ""}, {"conservative", "leaf=exact", ""}, {"conservative", "leaf=none", ""}}},
        {"secant",
         {{"order_1", "adaptive=false secant_steps=0", ""}, {"order_2", "adaptive=false secant_steps=1", ""}}},
        {"robust_cone",
         {{"conservative", "", ""},
          {"conservative", "binary_answer=above binary_steps=0", ""},
          {"conservative", "minimum_step=false refinement=none", ""},
          {"conservative", "preparation=falling_edges", ""}}},
        {"distance_map", {{"conservative", "", ""}, {"conservative", "max_steps=256 slices=64", ""}}},
    };
    std::map<std::string, std::set<PromiseText>> made;
    for (const Technique& technique : find_techniques({default_technique_root()}).techniques) {
        const std::set<PromiseText> promises = promises_of(technique.manifest);
        if (!promises.empty()) made[technique.manifest.id] = promises;
    }
    EXPECT_EQ(made, expected);
}

TEST(Promises, EveryShippedFolderIsUsable) {
    const TechniqueLibrary library = find_techniques({default_technique_root()});
    for (const auto& [id, reason] : library.broken)
        ADD_FAILURE() << id << ": " << reason;
    for (const Technique& technique : library.techniques)
        EXPECT_TRUE(std::filesystem::exists(technique.folder / "README.md")) << technique.manifest.id;
}

TEST_P(ShippedTechnique, KeepsItsPromises) {
    const Technique technique = shipped(GetParam());
    std::set<std::string> seen;
    for (const Check& check : verify_technique(device(), technique)) {
        if (check.skipped) {
            // Over the plane a shell ends with its patch: there is nothing to repeat.
            EXPECT_EQ(technique.manifest.shape.kind, "shell") << check.name << ": " << check.detail;
            EXPECT_EQ(check.drawn.value().where.view.relief.boundary, Boundary::repeat) << check.detail;
            continue;
        }
        seen.insert(check.name);
        EXPECT_TRUE(check.passed) << check.name << " {" << check.circumstances << "} " << check.detail;
    }
    for (const char* general :
         {"compiles", "timed and probed agree", "hits are in range", "a map of ones is the polygon", "work is counted"})
        EXPECT_TRUE(seen.contains(general)) << general;
    for (const PromiseDeclaration& declaration : technique.manifest.promises)
        EXPECT_TRUE(seen.contains(to_string(declaration.promise))) << to_string(declaration.promise);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedTechnique, testing::ValuesIn(shipped_ids()),
                         [](const auto& instance) { return instance.param; });

}  // namespace reliefbench::test
