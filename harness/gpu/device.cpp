#include "gpu/device.hpp"

#include "core/number_text.hpp"
#include "core/suggest.hpp"
#include "gpu/device_features.hpp"
#include "gpu/handles.hpp"
#include "gpu/shader_cache.hpp"
#include "gpu/shared_pipelines.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

namespace reliefbench::gpu {

namespace {

constexpr std::uint32_t needed_api = VK_API_VERSION_1_3;
constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";
constexpr std::string_view install_a_driver =
    "Install the driver of your GPU, or lavapipe, which runs on the CPU: apt-get install mesa-vulkan-drivers";

std::string version_text(std::uint32_t version) {
    return fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
                       VK_API_VERSION_PATCH(version));
}

DeviceType device_type(vk::PhysicalDeviceType type) {
    switch (type) {
        case vk::PhysicalDeviceType::eDiscreteGpu:
            return DeviceType::discrete;
        case vk::PhysicalDeviceType::eIntegratedGpu:
            return DeviceType::integrated;
        case vk::PhysicalDeviceType::eVirtualGpu:
            return DeviceType::virtual_gpu;
        case vk::PhysicalDeviceType::eCpu:
            return DeviceType::cpu;
        default:
            return DeviceType::other;
    }
}

/// The first queue family that draws, computes and has timestamps.
std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device) {
    constexpr auto needed = vk::QueueFlagBits::eGraphics | vk::QueueFlagBits::eCompute;
    const std::vector<vk::QueueFamilyProperties> families = device.getQueueFamilyProperties();
    for (std::uint32_t family = 0; family < families.size(); ++family) {
        if ((families[family].queueFlags & needed) == needed && families[family].timestampValidBits > 0) return family;
    }
    return std::nullopt;
}

std::string find_unusable_reason(const vk::raii::PhysicalDevice& device,
                                 const vk::PhysicalDeviceProperties& properties) {
    if (properties.apiVersion < needed_api)
        return fmt::format("it has Vulkan {}; 1.3 is needed", version_text(properties.apiVersion));
    if (!find_queue_family(device)) return "it has no queue that draws, computes and has timestamps";
    if (!has_needed_features(device)) return "it lacks features of Vulkan 1.3";
    return {};
}

std::string find_pci_address(const vk::raii::PhysicalDevice& device) {
    if (!has_extension(device, VK_EXT_PCI_BUS_INFO_EXTENSION_NAME)) return {};
    const auto chain =
        device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDevicePCIBusInfoPropertiesEXT>();
    const auto& pci = chain.get<vk::PhysicalDevicePCIBusInfoPropertiesEXT>();
    return fmt::format("{:04x}:{:02x}:{:02x}.{:x}", pci.pciDomain, pci.pciBus, pci.pciDevice, pci.pciFunction);
}

DeviceInfo describe(const vk::raii::PhysicalDevice& device, int index) {
    DeviceInfo info;
    info.index = index;
    const vk::PhysicalDeviceProperties properties = device.getProperties();
    info.name = properties.deviceName.data();
    info.type = device_type(properties.deviceType);
    info.api_version = version_text(properties.apiVersion);
    info.driver_version = version_text(properties.driverVersion);
    info.vendor_id = properties.vendorID;
    info.device_id = properties.deviceID;
    info.timestamp_period_ns = static_cast<double>(properties.limits.timestampPeriod);
    info.max_image_side =
        static_cast<int>(std::min({properties.limits.maxImageDimension2D, properties.limits.maxFramebufferWidth,
                                   properties.limits.maxFramebufferHeight}));
    info.max_tessellation_factor = static_cast<int>(properties.limits.maxTessellationGenerationLevel);
    info.max_storage_buffer_bytes = properties.limits.maxStorageBufferRange;
    info.max_anisotropy = static_cast<double>(properties.limits.maxSamplerAnisotropy);
    info.max_lod_bias = static_cast<double>(properties.limits.maxSamplerLodBias);

    info.unusable_reason = find_unusable_reason(device, properties);
    if (!info.unusable_reason.empty()) return info;

    const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    info.driver = driver.driverName.data();
    info.pci_address = find_pci_address(device);
    if (driver.driverInfo[0] != '\0') info.driver_version = driver.driverInfo.data();
    const std::uint32_t family = *find_queue_family(device);
    info.timestamp_valid_bits = static_cast<int>(device.getQueueFamilyProperties()[family].timestampValidBits);
    info.features = find_features(device);
    return info;
}

bool has_layer(const vk::raii::Context& context, const char* name) {
    const std::vector<vk::LayerProperties> layers = context.enumerateInstanceLayerProperties();
    return std::any_of(layers.begin(), layers.end(), [&](const vk::LayerProperties& layer) {
        return std::string_view(layer.layerName.data()) == name;
    });
}

VKAPI_ATTR VkBool32 VKAPI_CALL keep_message(VkDebugUtilsMessageSeverityFlagBitsEXT /*severity*/,
                                            VkDebugUtilsMessageTypeFlagsEXT /*types*/,
                                            const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    auto& log = *static_cast<MessageLog*>(user);
    const std::scoped_lock lock(log.mutex);
    log.messages.emplace_back(data->pMessage);
    return VK_FALSE;
}

vk::raii::Instance make_instance(const vk::raii::Context& context, bool validation) {
    const vk::ApplicationInfo application{.pApplicationName = "reliefbench", .apiVersion = needed_api};
    const std::array layers{validation_layer};
    const std::array extensions{VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    const std::array enabled{vk::ValidationFeatureEnableEXT::eSynchronizationValidation};
    const vk::ValidationFeaturesEXT features{.enabledValidationFeatureCount = enabled.size(),
                                             .pEnabledValidationFeatures = enabled.data()};
    vk::InstanceCreateInfo create{.pApplicationInfo = &application};
    if (validation) {
        if (!has_layer(context, validation_layer))
            fail("Vulkan's validation layer is not installed: apt-get install vulkan-validationlayers");
        create.pNext = &features;
        create.enabledLayerCount = layers.size();
        create.ppEnabledLayerNames = layers.data();
        create.enabledExtensionCount = extensions.size();
        create.ppEnabledExtensionNames = extensions.data();
    }
    try {
        return vk::raii::Instance(context, create);
    } catch (const vk::IncompatibleDriverError&) {
        fail("no Vulkan driver was found. {}", install_a_driver);
    } catch (const vk::SystemError& error) {
        fail("cannot start Vulkan: {}. {}", error.what(), install_a_driver);
    }
}

std::vector<vk::raii::PhysicalDevice> find_physical_devices(const vk::raii::Instance& instance) {
    std::vector<vk::raii::PhysicalDevice> devices;
    try {
        devices = instance.enumeratePhysicalDevices();
    } catch (const vk::SystemError& error) {
        fail("cannot list Vulkan devices: {}. {}", error.what(), install_a_driver);
    }
    if (devices.empty()) fail("there is no Vulkan device. {}", install_a_driver);
    return devices;
}

std::vector<DeviceInfo> describe_all(const std::vector<vk::raii::PhysicalDevice>& devices) {
    std::vector<DeviceInfo> infos;
    for (const vk::raii::PhysicalDevice& device : devices) {
        const auto index = static_cast<int>(infos.size());
        translate_errors("ask what it can do", fmt::format("Vulkan device {}", index),
                         [&] { infos.push_back(describe(device, index)); });
    }
    return infos;
}

vk::raii::DebugUtilsMessengerEXT make_messenger(const vk::raii::Instance& instance, MessageLog& log) {
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    return vk::raii::DebugUtilsMessengerEXT(
        instance, vk::DebugUtilsMessengerCreateInfoEXT{.messageSeverity = Severity::eWarning | Severity::eError,
                                                       .messageType = vk::DebugUtilsMessageTypeFlagBitsEXT::eValidation,
                                                       .pfnUserCallback = keep_message,
                                                       .pUserData = &log});
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

std::string device_table(const std::vector<DeviceInfo>& devices) {
    std::string table;
    for (const DeviceInfo& device : devices)
        table += fmt::format("\n  {}: {} ({})", device.index, device.name,
                             device.unusable_reason.empty() ? to_string(device.type) : device.unusable_reason);
    return table;
}

/// The usable one of the lowest type; the first of several.
std::optional<std::size_t> best_of(const std::vector<DeviceInfo>& devices, std::string_view name_part) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const bool matches = lower(devices[i].name).find(name_part) != std::string::npos;
        if (!matches || !devices[i].unusable_reason.empty()) continue;
        if (!best || devices[i].type < devices[*best].type) best = i;
    }
    return best;
}

}  // namespace

std::string to_string(DeviceType type) {
    switch (type) {
        case DeviceType::discrete:
            return "discrete";
        case DeviceType::integrated:
            return "integrated";
        case DeviceType::virtual_gpu:
            return "virtual";
        case DeviceType::cpu:
            return "CPU";
        case DeviceType::other:
            return "other";
    }
    return "other";
}

bool DeviceInfo::has_feature(const std::string& feature) const {
    return std::find(features.begin(), features.end(), feature) != features.end();
}

std::vector<DeviceInfo> list_devices() {
    const vk::raii::Context context(vkGetInstanceProcAddr);
    const vk::raii::Instance instance = make_instance(context, false);
    return describe_all(find_physical_devices(instance));
}

std::size_t choose_device(const std::vector<DeviceInfo>& devices, const std::string& choice) {
    if (choice.empty()) {
        const auto best = best_of(devices, "");
        if (!best) fail("no Vulkan device can run reliefbench:{}\n{}", device_table(devices), install_a_driver);
        return *best;
    }
    if (const auto number = whole_text_as<std::size_t>(choice)) {
        const std::size_t index = *number;
        if (index >= devices.size()) fail("there is no Vulkan device {}. There are:{}", index, device_table(devices));
        if (!devices[index].unusable_reason.empty())
            fail("Vulkan device {} ({}) cannot run reliefbench: {}", index, devices[index].name,
                 devices[index].unusable_reason);
        return index;
    }
    const auto found = best_of(devices, lower(choice));
    if (!found) fail("no usable Vulkan device is called '{}'. There are:{}", choice, device_table(devices));
    return *found;
}

Device::Device(const DeviceOptions& options)
    : handles_(std::make_unique<DeviceHandles>()),
      shader_cache_(std::make_unique<ShaderCache>()),
      shared_pipelines_(std::make_unique<SharedPipelines>()) {
    std::string choice = options.choice;
    if (const char* environment = std::getenv("RELIEFBENCH_DEVICE"); choice.empty() && environment)
        choice = environment;

    DeviceHandles& handles = *handles_;
    handles.on_submit = options.on_submit;
    handles.on_end = options.on_end;
    handles.instance = make_instance(handles.context, options.validation);
    if (options.validation) handles.messenger = make_messenger(handles.instance, *handles.messages);
    std::vector<vk::raii::PhysicalDevice> devices = find_physical_devices(handles.instance);
    const std::vector<DeviceInfo> infos = describe_all(devices);
    const std::size_t chosen = choose_device(infos, choice);

    handles.info = infos[chosen];
    handles.physical_device = std::move(devices[chosen]);
    handles.memory = handles.physical_device.getMemoryProperties();
    handles.queue_family = *find_queue_family(handles.physical_device);
    translate_errors("open the device", handles.info.name, [&] {
        handles.device = make_device_with(handles.physical_device, handles.queue_family, handles.info.features);
        handles.queue = vk::raii::Queue(handles.device, handles.queue_family, 0);
        handles.command_pool =
            vk::raii::CommandPool(handles.device, vk::CommandPoolCreateInfo{.queueFamilyIndex = handles.queue_family});
        handles.pipeline_cache = vk::raii::PipelineCache(handles.device, vk::PipelineCacheCreateInfo{});
    });
}

Device::~Device() = default;

const DeviceInfo& Device::info() const {
    return handles_->info;
}

bool DeviceHandles::wait_until_idle() const {
    try {
        device.waitIdle();
    } catch (const vk::DeviceLostError&) {
        return false;
    } catch (const vk::SystemError&) {
        // It could not wait, but is not lost.
    }
    return true;
}

bool Device::is_lost() const {
    return !handles_->wait_until_idle();
}

std::vector<std::string> Device::validation_messages() const {
    const std::scoped_lock lock(handles_->messages->mutex);
    return handles_->messages->messages;
}

}  // namespace reliefbench::gpu
