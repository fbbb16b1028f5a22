// Linked into every program under AddressSanitizer: what Mesa's driver, its LLVM, Vulkan's loader, the validation layer
// and OpenImageIO (its own messages) leave behind at the end is not ours. It is told apart by the library that allocated
// it, which must still be loaded then. Objects of Vulkan that we leave behind are for the validation layer to tell.

extern "C" {

const char* __lsan_default_suppressions() {
    return "leak:libvulkan_lvp.so\n"
           "leak:libLLVM\n"
           "leak:libvulkan.so\n"
           "leak:libOpenImageIO\n"
           "leak:libVkLayer_khronos_validation.so\n";
}

/// In place of the system's: libraries stay loaded.
int dlclose(void* /*library*/) {
    return 0;
}
}
