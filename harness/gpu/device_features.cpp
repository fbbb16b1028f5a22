#include "gpu/device_features.hpp"

#include "gpu/device.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>

namespace reliefbench::gpu {

namespace {

/// Structures of features chained to one VkPhysicalDeviceFeatures2, each made when it is first asked for.
class FeatureChain {
public:
    /// Where the flag `member` of the structure `Features` stands.
    template <typename Features>
    vk::Bool32& flag(vk::Bool32 Features::*member) {
        if constexpr (std::is_same_v<Features, vk::PhysicalDeviceFeatures>) {
            return head_.features.*member;
        } else {
            return structure<Features>().*member;
        }
    }

    vk::PhysicalDeviceFeatures2& head() { return head_; }

private:
    template <typename Features>
    Features& structure() {
        std::shared_ptr<void>& kept = structures_[Features::structureType];
        if (!kept) {
            auto made = std::make_shared<Features>();
            made->pNext = head_.pNext;
            head_.pNext = made.get();
            kept = std::move(made);
        }
        return *static_cast<Features*>(kept.get());
    }

    vk::PhysicalDeviceFeatures2 head_;
    std::map<vk::StructureType, std::shared_ptr<void>> structures_;
};

using Flag = std::function<vk::Bool32&(FeatureChain&)>;

template <typename Features>
Flag flag(vk::Bool32 Features::*member) {
    return [member](FeatureChain& chain) -> vk::Bool32& { return chain.flag(member); };
}

/// What technique.json and the harness ask for by name: had where the device has the extensions and all of the flags,
/// and then enabled.
struct DeviceFeature {
    std::string name;
    std::vector<Flag> flags;
    std::vector<const char*> extensions = {};
};

const std::vector<DeviceFeature>& device_features() {
    using Core = vk::PhysicalDeviceFeatures;
    using Vulkan11 = vk::PhysicalDeviceVulkan11Features;
    using Vulkan12 = vk::PhysicalDeviceVulkan12Features;
    using Vulkan13 = vk::PhysicalDeviceVulkan13Features;
    using Mesh = vk::PhysicalDeviceMeshShaderFeaturesEXT;
    using Structure = vk::PhysicalDeviceAccelerationStructureFeaturesKHR;
    using Query = vk::PhysicalDeviceRayQueryFeaturesKHR;
    using Executable = vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR;
    // None that changes what is compiled of shaders that do not ask for it, as robustness would.
    static const std::vector<DeviceFeature> features{
        {"tessellationShader", {flag(&Core::tessellationShader)}},
        {"fragmentStoresAndAtomics", {flag(&Core::fragmentStoresAndAtomics)}},
        {"vertexPipelineStoresAndAtomics", {flag(&Core::vertexPipelineStoresAndAtomics)}},
        {"pipelineStatisticsQuery", {flag(&Core::pipelineStatisticsQuery)}},
        {"shaderStorageImageExtendedFormats", {flag(&Core::shaderStorageImageExtendedFormats)}},
        {"geometryShader", {flag(&Core::geometryShader)}},
        {"sampleRateShading", {flag(&Core::sampleRateShading)}},
        {"samplerAnisotropy", {flag(&Core::samplerAnisotropy)}},
        {"shaderFloat64", {flag(&Core::shaderFloat64)}},
        {"shaderInt64", {flag(&Core::shaderInt64)}},
        {"shaderInt16", {flag(&Core::shaderInt16)}},
        {"shaderDrawParameters", {flag(&Vulkan11::shaderDrawParameters)}},
        {"shaderFloat16", {flag(&Vulkan12::shaderFloat16)}},
        {"shaderInt8", {flag(&Vulkan12::shaderInt8)}},
        {"scalarBlockLayout", {flag(&Vulkan12::scalarBlockLayout)}},
        {"bufferDeviceAddress", {flag(&Vulkan12::bufferDeviceAddress)}},
        {"shaderDemoteToHelperInvocation", {flag(&Vulkan13::shaderDemoteToHelperInvocation)}},
        {"subgroupSizeControl", {flag(&Vulkan13::subgroupSizeControl)}},
        {"VK_EXT_mesh_shader", {flag(&Mesh::meshShader), flag(&Mesh::taskShader)}, {VK_EXT_MESH_SHADER_EXTENSION_NAME}},
        {"VK_KHR_ray_query",
         {flag(&Query::rayQuery), flag(&Structure::accelerationStructure), flag(&Vulkan12::bufferDeviceAddress)},
         {VK_KHR_RAY_QUERY_EXTENSION_NAME, VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
          VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME}},
        {pipeline_executable_feature,
         {flag(&Executable::pipelineExecutableInfo)},
         {VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME}},
    };
    return features;
}

const std::vector<DeviceFeature>& needed_features() {
    using Vulkan13 = vk::PhysicalDeviceVulkan13Features;
    static const std::vector<DeviceFeature> features{
        {"dynamicRendering", {flag(&Vulkan13::dynamicRendering)}},
        {"synchronization2", {flag(&Vulkan13::synchronization2)}},
        {"maintenance4", {flag(&Vulkan13::maintenance4)}},
    };
    return features;
}

/// Structures of extensions that a device lacks mean nothing to it, and are not asked for.
std::vector<const DeviceFeature*> features_that_device_has(const vk::raii::PhysicalDevice& device,
                                                           const std::vector<DeviceFeature>& features) {
    FeatureChain chain;
    std::vector<const DeviceFeature*> possible;
    for (const DeviceFeature& feature : features) {
        const bool has_extensions = std::ranges::all_of(
            feature.extensions, [&](const char* extension) { return has_extension(device, extension); });
        if (!has_extensions) continue;
        possible.push_back(&feature);
        for (const Flag& flag : feature.flags)
            flag(chain) = false;
    }
    const auto& dispatch = *device.getDispatcher();
    dispatch.vkGetPhysicalDeviceFeatures2(static_cast<VkPhysicalDevice>(*device),
                                          reinterpret_cast<VkPhysicalDeviceFeatures2*>(&chain.head()));
    std::erase_if(possible, [&](const DeviceFeature* feature) {
        return !std::ranges::all_of(feature->flags, [&](const Flag& flag) { return flag(chain) == VK_TRUE; });
    });
    return possible;
}

}  // namespace

std::vector<std::string> feature_names() {
    std::vector<std::string> names;
    for (const DeviceFeature& feature : device_features())
        names.push_back(feature.name);
    return names;
}

bool has_extension(const vk::raii::PhysicalDevice& device, std::string_view name) {
    const std::vector<vk::ExtensionProperties> extensions = device.enumerateDeviceExtensionProperties();
    return std::ranges::any_of(extensions, [&](const vk::ExtensionProperties& extension) {
        return name == std::string_view(extension.extensionName.data());
    });
}

bool has_needed_features(const vk::raii::PhysicalDevice& device) {
    return features_that_device_has(device, needed_features()).size() == needed_features().size();
}

std::vector<std::string> find_features(const vk::raii::PhysicalDevice& device) {
    std::vector<std::string> names;
    for (const DeviceFeature* feature : features_that_device_has(device, device_features()))
        names.push_back(feature->name);
    return names;
}

vk::raii::Device make_device_with(const vk::raii::PhysicalDevice& physical_device, std::uint32_t queue_family,
                                  const std::vector<std::string>& features) {
    FeatureChain chain;
    std::vector<const char*> extensions;
    const auto enable = [&](const DeviceFeature& feature) {
        for (const Flag& flag : feature.flags)
            flag(chain) = true;
        extensions.insert(extensions.end(), feature.extensions.begin(), feature.extensions.end());
    };
    std::ranges::for_each(needed_features(), enable);
    for (const DeviceFeature& feature : device_features()) {
        if (std::ranges::find(features, feature.name) != features.end()) enable(feature);
    }
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = queue_family, .queueCount = 1, .pQueuePriorities = &priority};
    return vk::raii::Device(physical_device,
                            vk::DeviceCreateInfo{.pNext = &chain.head(),
                                                 .queueCreateInfoCount = 1,
                                                 .pQueueCreateInfos = &queue,
                                                 .enabledExtensionCount = static_cast<std::uint32_t>(extensions.size()),
                                                 .ppEnabledExtensionNames = extensions.data()});
}

}  // namespace reliefbench::gpu
