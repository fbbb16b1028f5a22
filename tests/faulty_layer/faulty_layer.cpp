// A Vulkan layer between the program and the driver (or the validation layer) that makes calls fail: every function
// that returns a result and that the program uses. One instance and one device at a time.

#include "faulty_layer.hpp"

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>
#include <vector>

namespace {

struct Faults {
    std::mutex mutex;
    std::vector<const char*> calls;
    long fail_at = -1;
    bool lose_device = false;
    bool device_is_lost = false;
};

Faults& faults() {
    static Faults state;
    return state;
}

/// Counts the call; VK_SUCCESS when it is to be passed on.
VkResult begin_call(const char* name) {
    Faults& state = faults();
    const std::scoped_lock lock(state.mutex);
    const long call = static_cast<long>(state.calls.size());
    state.calls.push_back(name);
    if (state.device_is_lost) return VK_ERROR_DEVICE_LOST;
    if (call != state.fail_at) return VK_SUCCESS;
    state.device_is_lost = state.lose_device;
    return state.lose_device ? VK_ERROR_DEVICE_LOST : VK_ERROR_OUT_OF_DEVICE_MEMORY;
}

template <std::size_t size>
struct Name {
    constexpr Name(const char (&text)[size]) { std::copy_n(text, size, characters); }
    char characters[size];
};

/// A function of Vulkan that can fail, by its name and type.
template <Name name, typename Function>
struct Faulty;

template <Name name, typename... Arguments>
struct Faulty<name, VkResult(VKAPI_PTR*)(Arguments...)> {
    static inline VkResult(VKAPI_PTR* next)(Arguments...) = nullptr;

    static VKAPI_ATTR VkResult VKAPI_CALL call(Arguments... arguments) {
        const VkResult result = begin_call(name.characters);
        // A lost device ends its work: the validation layer, which stands below, is to see that.
        constexpr bool waits = std::string_view(name.characters) == "vkWaitForFences" ||
                               std::string_view(name.characters) == "vkDeviceWaitIdle";
        if (waits && result == VK_ERROR_DEVICE_LOST) next(arguments...);
        return result == VK_SUCCESS ? next(arguments...) : result;
    }

    static PFN_vkVoidFunction intercept(PFN_vkVoidFunction found) {
        next = reinterpret_cast<decltype(next)>(found);
        return reinterpret_cast<PFN_vkVoidFunction>(&call);
    }
};

struct Interception {
    const char* name;
    PFN_vkVoidFunction (*intercept)(PFN_vkVoidFunction next);
};

template <Name name, typename Function>
constexpr Interception faulty() {
    return {name.characters, &Faulty<name, Function>::intercept};
}

constexpr std::array instance_functions{
    faulty<"vkEnumeratePhysicalDevices", PFN_vkEnumeratePhysicalDevices>(),
    faulty<"vkEnumerateDeviceExtensionProperties", PFN_vkEnumerateDeviceExtensionProperties>(),
    faulty<"vkGetPhysicalDeviceImageFormatProperties", PFN_vkGetPhysicalDeviceImageFormatProperties>(),
};

constexpr std::array device_functions{
    faulty<"vkAllocateCommandBuffers", PFN_vkAllocateCommandBuffers>(),
    faulty<"vkAllocateDescriptorSets", PFN_vkAllocateDescriptorSets>(),
    faulty<"vkAllocateMemory", PFN_vkAllocateMemory>(),
    faulty<"vkBeginCommandBuffer", PFN_vkBeginCommandBuffer>(),
    faulty<"vkBindBufferMemory", PFN_vkBindBufferMemory>(),
    faulty<"vkBindImageMemory", PFN_vkBindImageMemory>(),
    faulty<"vkCreateBuffer", PFN_vkCreateBuffer>(),
    faulty<"vkCreateCommandPool", PFN_vkCreateCommandPool>(),
    faulty<"vkCreateComputePipelines", PFN_vkCreateComputePipelines>(),
    faulty<"vkCreateDescriptorPool", PFN_vkCreateDescriptorPool>(),
    faulty<"vkCreateDescriptorSetLayout", PFN_vkCreateDescriptorSetLayout>(),
    faulty<"vkCreateFence", PFN_vkCreateFence>(),
    faulty<"vkCreateImage", PFN_vkCreateImage>(),
    faulty<"vkCreateImageView", PFN_vkCreateImageView>(),
    faulty<"vkCreatePipelineCache", PFN_vkCreatePipelineCache>(),
    faulty<"vkCreatePipelineLayout", PFN_vkCreatePipelineLayout>(),
    faulty<"vkCreateQueryPool", PFN_vkCreateQueryPool>(),
    faulty<"vkCreateSampler", PFN_vkCreateSampler>(),
    faulty<"vkCreateShaderModule", PFN_vkCreateShaderModule>(),
    faulty<"vkDeviceWaitIdle", PFN_vkDeviceWaitIdle>(),
    faulty<"vkEndCommandBuffer", PFN_vkEndCommandBuffer>(),
    faulty<"vkGetPipelineExecutablePropertiesKHR", PFN_vkGetPipelineExecutablePropertiesKHR>(),
    faulty<"vkGetPipelineExecutableStatisticsKHR", PFN_vkGetPipelineExecutableStatisticsKHR>(),
    faulty<"vkGetQueryPoolResults", PFN_vkGetQueryPoolResults>(),
    faulty<"vkMapMemory", PFN_vkMapMemory>(),
    faulty<"vkQueueSubmit2", PFN_vkQueueSubmit2>(),
    faulty<"vkResetFences", PFN_vkResetFences>(),
    faulty<"vkWaitForFences", PFN_vkWaitForFences>(),
};

PFN_vkGetInstanceProcAddr next_instance_function = nullptr;
PFN_vkGetDeviceProcAddr next_device_function = nullptr;
PFN_vkCreateGraphicsPipelines next_create_graphics_pipelines = nullptr;
PFN_vkGetPhysicalDeviceFeatures2 next_get_features = nullptr;

VKAPI_ATTR void VKAPI_CALL get_features(VkPhysicalDevice device, VkPhysicalDeviceFeatures2* features) {
    next_get_features(device, features);
    if (std::getenv("RELIEFBENCH_WITHOUT_TESSELLATION") != nullptr) features->features.tessellationShader = VK_FALSE;
    if (std::getenv("RELIEFBENCH_WITHOUT_ANISOTROPY") != nullptr) features->features.samplerAnisotropy = VK_FALSE;
}

/// Whether the variable of the environment names a value of one of the pipeline's specialization constants.
bool has_constant(const VkGraphicsPipelineCreateInfo& pipeline, const char* variable) {
    const char* const text = std::getenv(variable);
    if (text == nullptr) return false;
    const int wanted = std::atoi(text);
    for (std::uint32_t stage = 0; stage < pipeline.stageCount; ++stage) {
        const VkSpecializationInfo* const constants = pipeline.pStages[stage].pSpecializationInfo;
        for (std::uint32_t entry = 0; constants != nullptr && entry < constants->mapEntryCount; ++entry) {
            int value = 0;
            std::memcpy(&value, static_cast<const char*>(constants->pData) + constants->pMapEntries[entry].offset,
                        sizeof value);
            if (value == wanted) return true;
        }
    }
    return false;
}

VKAPI_ATTR VkResult VKAPI_CALL create_graphics_pipelines(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                                         const VkGraphicsPipelineCreateInfo* infos,
                                                         const VkAllocationCallbacks* allocator,
                                                         VkPipeline* pipelines) {
    for (std::uint32_t i = 0; i < count; ++i) {
        if (has_constant(infos[i], "RELIEFBENCH_CRASH_AT")) {
            std::signal(SIGSEGV, SIG_DFL);  // AddressSanitizer has a handler of its own
            std::raise(SIGSEGV);
        }
        if (has_constant(infos[i], "RELIEFBENCH_LOSE_DEVICE_AT")) faults().device_is_lost = true;
        if (has_constant(infos[i], "RELIEFBENCH_REFUSE_MEMORY_AT")) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    }
    const VkResult result = begin_call("vkCreateGraphicsPipelines");
    return result == VK_SUCCESS ? next_create_graphics_pipelines(device, cache, count, infos, allocator, pipelines)
                                : result;
}

/// The layer's own part of the chain that the loader hands to vkCreateInstance and vkCreateDevice.
template <typename CreateInfo>
CreateInfo* find_link(const void* chain, VkStructureType type) {
    for (auto* info = static_cast<CreateInfo*>(const_cast<void*>(chain)); info != nullptr;
         info = static_cast<CreateInfo*>(const_cast<void*>(info->pNext))) {
        if (info->sType == type && info->function == VK_LAYER_LINK_INFO) return info;
    }
    return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* create,
                                               const VkAllocationCallbacks* allocator, VkInstance* instance) {
    if (const VkResult result = begin_call("vkCreateInstance"); result != VK_SUCCESS) return result;
    auto* link = find_link<VkLayerInstanceCreateInfo>(create->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (link == nullptr) return VK_ERROR_INITIALIZATION_FAILED;
    next_instance_function = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto next =
        reinterpret_cast<PFN_vkCreateInstance>(next_instance_function(VK_NULL_HANDLE, "vkCreateInstance"));
    return next(create, allocator, instance);
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical_device, const VkDeviceCreateInfo* create,
                                             const VkAllocationCallbacks* allocator, VkDevice* device) {
    if (const VkResult result = begin_call("vkCreateDevice"); result != VK_SUCCESS) return result;
    auto* link = find_link<VkLayerDeviceCreateInfo>(create->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (link == nullptr) return VK_ERROR_INITIALIZATION_FAILED;
    const PFN_vkGetInstanceProcAddr instance_function = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    next_device_function = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    const auto next = reinterpret_cast<PFN_vkCreateDevice>(instance_function(VK_NULL_HANDLE, "vkCreateDevice"));
    return next(physical_device, create, allocator, device);
}

template <std::size_t size>
PFN_vkVoidFunction intercept(const std::array<Interception, size>& functions, const char* name,
                             PFN_vkVoidFunction next) {
    const auto found = std::find_if(functions.begin(), functions.end(), [name](const Interception& function) {
        return std::string_view(function.name) == name;
    });
    return next != nullptr && found != functions.end() ? found->intercept(next) : next;
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_device_function(VkDevice device, const char* name) {
    const std::string_view wanted = name;
    if (wanted == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(&get_device_function);
    const PFN_vkVoidFunction next = next_device_function(device, name);
    if (wanted == "vkCreateGraphicsPipelines") {
        next_create_graphics_pipelines = reinterpret_cast<PFN_vkCreateGraphicsPipelines>(next);
        return reinterpret_cast<PFN_vkVoidFunction>(&create_graphics_pipelines);
    }
    return intercept(device_functions, name, next);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL get_instance_function(VkInstance instance, const char* name) {
    const std::string_view wanted = name;
    if (wanted == "vkCreateInstance") return reinterpret_cast<PFN_vkVoidFunction>(&create_instance);
    if (wanted == "vkCreateDevice") return reinterpret_cast<PFN_vkVoidFunction>(&create_device);
    if (wanted == "vkGetInstanceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(&get_instance_function);
    if (wanted == "vkGetDeviceProcAddr") return reinterpret_cast<PFN_vkVoidFunction>(&get_device_function);
    const PFN_vkVoidFunction next = next_instance_function(instance, name);
    if (wanted == "vkGetPhysicalDeviceFeatures2") {
        next_get_features = reinterpret_cast<PFN_vkGetPhysicalDeviceFeatures2>(next);
        return reinterpret_cast<PFN_vkVoidFunction>(&get_features);
    }
    return intercept(instance_functions, name, next);
}

}  // namespace

extern "C" {

VKAPI_ATTR VkResult VKAPI_CALL vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
    version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = get_instance_function;
    version->pfnGetDeviceProcAddr = get_device_function;
    version->pfnGetPhysicalDeviceProcAddr = nullptr;
    return VK_SUCCESS;
}

void faulty_layer_start(long fail_at, bool lose_device) {
    Faults& state = faults();
    const std::scoped_lock lock(state.mutex);
    state.calls.clear();
    state.fail_at = fail_at;
    state.lose_device = lose_device;
    state.device_is_lost = false;
}

long faulty_layer_calls() {
    Faults& state = faults();
    const std::scoped_lock lock(state.mutex);
    return static_cast<long>(state.calls.size());
}

const char* faulty_layer_name(long call) {
    Faults& state = faults();
    const std::scoped_lock lock(state.mutex);
    return call >= 0 && static_cast<std::size_t>(call) < state.calls.size() ? state.calls[call] : nullptr;
}
}
