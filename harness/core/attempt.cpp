#include "core/attempt.hpp"

#include "core/error.hpp"

#include <new>

namespace reliefbench {

bool fits_in_memory(const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

std::string failure_of(const std::function<void()>& work) {
    try {
        return fits_in_memory(work) ? "" : memory_used_up;
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace reliefbench
