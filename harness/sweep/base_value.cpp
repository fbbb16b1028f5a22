#include "sweep/base_value.hpp"

#include "core/suggest.hpp"
#include "scene/surface/mesh_file.hpp"
#include "sweep/input_path.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reliefbench {

const std::vector<std::string>& base_words() {
    static const std::vector<std::string> words{"plane", "cylinder", "sphere", "saddle"};
    return words;
}

BaseSource read_base_value(const JsonView& view) {
    BaseSource source;
    if (view.json().is_object()) {
        view.require_only({"file"});
        source.kind = BaseSource::Kind::file;
        source.file = view.at("file").string();
        if (!is_mesh_file_name(source.file)) view.at("file").fail_expected(readable_meshes());
        return source;
    }
    if (!view.json().is_string()) {
        view.fail_expected(
            fmt::format("one of {}, the path of a mesh file, or {{\"file\": path}}", join(base_words())));
    }
    const std::string word = view.string();
    const auto known = std::ranges::find(base_words(), word);
    if (known != base_words().end()) {
        source.kind = static_cast<BaseSource::Kind>(known - base_words().begin());
    } else if (is_mesh_file_name(word)) {
        source.kind = BaseSource::Kind::file;
        source.file = word;
    } else {
        view.fail_here(fmt::format("no base '{}'{}; give one of {}, or {}", word, did_you_mean(word, base_words()),
                                   join(base_words()), readable_meshes()));
    }
    return source;
}

Json resolve_base_path(const JsonView& view, const std::vector<std::filesystem::path>& folders) {
    if (read_base_value(view).kind != BaseSource::Kind::file) return view.json();
    if (!view.json().is_object()) return resolve_input_path(view, folders);
    return {{"file", resolve_input_path(view.at("file"), folders)}};
}

std::string base_label(const BaseSource& source) {
    return source.kind == BaseSource::Kind::file ? source.file.filename().string()
                                                 : base_words()[static_cast<std::size_t>(source.kind)];
}

}  // namespace reliefbench
