#include "cli/threshold.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"

#include <optional>
#include <string_view>

namespace reliefbench {

double parse_threshold(const std::string& text, const std::string& option) {
    std::string_view digits = text;
    const bool percent = digits.ends_with('%');
    if (percent) digits.remove_suffix(1);
    if (percent && digits.ends_with(' ')) digits.remove_suffix(1);
    const std::optional<double> number = whole_text_as<double>(digits);
    if (!number) fail("{}: expected a fraction such as 2% or 0.02, found '{}'", option, text);
    const double fraction = percent ? *number / 100 : *number;
    if (!(fraction > 0 && fraction < 1)) {
        fail("{}: expected more than 0 and less than 100 %, found '{}'{}", option, text,
             !percent && *number >= 1 && *number < 100 ? "; per cent are written with their sign, " + text + "%" : "");
    }
    return fraction;
}

}  // namespace reliefbench
