#include "verify/promise_checks.hpp"

namespace reliefbench {

void check_promise(CheckList& list, const PromiseDeclaration& declaration) {
    switch (declaration.promise) {
        case Promise::first_hit:
            return check_first_hit(list, declaration);
        case Promise::conservative:
            return check_conservative(list, declaration);
        case Promise::order_1:
            return check_order_1(list, declaration);
        case Promise::order_2:
            return check_order_2(list, declaration);
    }
}

}  // namespace reliefbench
