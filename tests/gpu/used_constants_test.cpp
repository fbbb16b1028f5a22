#include "gpu/used_constants.hpp"

#include "core/file.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace reliefbench::gpu {
namespace {

TEST(UsedConstants, AreThoseThatFunctionsReferTo) {
    const TemporaryFolder folder;
    write_text_file(folder / "main.comp", R"(
        layout(constant_id = 2) const int in_loop = 4;
        layout(constant_id = 3) const int only_declared = 8;
        layout(constant_id = 5) const float in_expression = 0.5;
        layout(constant_id = 7) const bool in_condition = false;
        layout(constant_id = 11) const int in_array_size = 3;
        layout(constant_id = 13) const int word = 1;
        layout(constant_id = 17) const float also_only_declared = 37.0;
        const int word_second = 1;
        layout(local_size_x = 8) in;
        layout(set = 0, binding = 0, std430) buffer Values { float values[]; };
        void main() {
            float table[in_array_size];
            table[0] = clamp(values[0], 0.0, 1.0);
            for (int i = 0; i < in_loop; ++i) values[i] += 2.0 * in_expression + table[0];
            if (in_condition) values[1] = 3.0;
            if (word == word_second) values[2] = 170.0;
        })");
    const SpirV module = compile_shader({.stage = ShaderStage::compute,
                                         .file = "main.comp",
                                         .roots = {folder.path()},
                                         .generated = {},
                                         .preamble = ""});
    EXPECT_THAT(used_constants(module), testing::ElementsAre(2, 5, 7, 11, 13));
}

}  // namespace
}  // namespace reliefbench::gpu
