#include "verify/conformance.hpp"

#include "verify/general_checks.hpp"
#include "verify/promise_checks.hpp"

namespace reliefbench {

std::vector<Check> verify_technique(const gpu::Device& device, const Technique& technique,
                                    const std::function<void(const Check&)>& on_check,
                                    const PreparationSettings& preparation) {
    CheckList list(device, technique, on_check, preparation);
    if (!check_supported(list) || !check_compiles(list)) return list.take();
    check_pictures(list);
    check_polygon(list);
    check_work(list);
    for (const PromiseDeclaration& declaration : technique.manifest.promises)
        check_promise(list, declaration);
    return list.take();
}

}  // namespace reliefbench
