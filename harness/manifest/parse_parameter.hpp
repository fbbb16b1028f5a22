#pragma once

#include "core/json.hpp"
#include "manifest/parameter.hpp"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace reliefbench {

/// Every identifier that the generated preamble declares or defines; two alike would not compile.
class GlslNames {
public:
    explicit GlslNames(int contract) : contract_(contract) {}

    /// Of a parameter or a map.
    void add_checked(const JsonView& view);
    /// The JSON of the view must outlive this.
    void add(const JsonView& view, const std::string& name);
    /// A name that is one of these is an Error at its view.
    void require_none_of(const std::set<std::string>& names_of_shaders) const;

private:
    int contract_;
    std::set<std::string> names_;
    /// In the order in which they were added.
    std::vector<std::pair<std::string, JsonView>> places_;
};

/// A string of one line that is not empty.
std::string parse_line(const JsonView& view);

/// A full declaration, but for its "only_with".
Parameter parse_parameter(const JsonView& view, GlslNames& names);

/// A parameter of an included set with another default, a narrower range, another published value or help.
Parameter parse_override(const JsonView& view, Parameter parameter, const std::string& set);

/// {"refinement": "binary", "leaf": ["linear", "exact"]}: each name one of the parameters given, with one value or a
/// list of them.
std::vector<ParameterCondition> parse_conditions(const JsonView& view, const std::vector<Parameter>& parameters);

}  // namespace reliefbench
