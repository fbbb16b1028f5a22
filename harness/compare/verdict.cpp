#include "compare/verdict.hpp"

namespace reliefbench {

std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::same:
            return "same";
        case Verdict::faster:
            return "faster";
        case Verdict::slower:
            return "slower";
        case Verdict::undecided:
            return "undecided";
    }
    return "";
}

}  // namespace reliefbench
