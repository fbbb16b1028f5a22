#include "gpu/device_state.hpp"

#include "gpu/device.hpp"

#include <dlfcn.h>

#include <fstream>
#include <vector>

namespace reliefbench::gpu {

namespace {

namespace fs = std::filesystem;

class NothingTells : public DeviceStateSource {
public:
    DeviceState read() override { return {}; }
};

/// The first number in a file of sysfs, scaled; empty where it cannot be read.
std::optional<double> read_number(const fs::path& file, double scale) {
    std::ifstream stream(file);
    double number = 0;
    if (!(stream >> number)) return std::nullopt;
    return number * scale;
}

/// Empty where there is no such folder.
std::vector<fs::path> entries(const fs::path& folder, const std::string& prefix) {
    std::vector<fs::path> result;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (entry->path().filename().string().starts_with(prefix)) result.push_back(entry->path());
    }
    return result;
}

class AmdgpuState : public DeviceStateSource {
public:
    explicit AmdgpuState(fs::path hwmon) : hwmon_(std::move(hwmon)) {}

    DeviceState read() override {
        constexpr double mhz_per_hz = 1e-6;
        constexpr double degrees_per_millidegree = 1e-3;
        return {.clock_mhz = read_number(hwmon_ / "freq1_input", mhz_per_hz),
                .memory_clock_mhz = read_number(hwmon_ / "freq2_input", mhz_per_hz),
                .temperature_c = read_number(hwmon_ / "temp1_input", degrees_per_millidegree),
                .throttled = std::nullopt};
    }

private:
    fs::path hwmon_;
};

class CpuState : public DeviceStateSource {
public:
    explicit CpuState(std::vector<fs::path> files) : files_(std::move(files)) {}

    DeviceState read() override {
        constexpr double mhz_per_khz = 1e-3;
        double sum = 0;
        std::size_t told = 0;
        for (const fs::path& file : files_) {
            if (const std::optional<double> mhz = read_number(file, mhz_per_khz)) {
                sum += *mhz;
                ++told;
            }
        }
        DeviceState state;
        if (told > 0) state.clock_mhz = sum / static_cast<double>(told);
        return state;
    }

private:
    std::vector<fs::path> files_;
};

/// The few functions and constants of NVML (nvml.h) that are needed: they are looked up at run time, so that
/// reliefbench needs neither NVIDIA's headers nor its driver.
struct Nvml {
    using Handle = void*;
    static constexpr int success = 0;
    static constexpr int graphics_clock = 0;
    static constexpr int memory_clock = 2;
    static constexpr int gpu_temperature = 0;
    /// SwPowerCap, HwSlowdown, SwThermalSlowdown, HwThermalSlowdown, HwPowerBrakeSlowdown.
    static constexpr unsigned long long heat_or_power = 0x4 | 0x8 | 0x20 | 0x40 | 0x80;

    int (*init)() = nullptr;
    int (*shutdown)() = nullptr;
    int (*handle_by_pci)(const char*, Handle*) = nullptr;
    int (*clock)(Handle, int, unsigned*) = nullptr;
    int (*temperature)(Handle, int, unsigned*) = nullptr;
    int (*throttle_reasons)(Handle, unsigned long long*) = nullptr;
};

struct CloseLibrary {
    void operator()(void* library) const { dlclose(library); }
};
using Library = std::unique_ptr<void, CloseLibrary>;

template <typename Function>
bool look_up(const Library& library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library.get(), name));
    return function != nullptr;
}

class NvmlState : public DeviceStateSource {
public:
    /// Null where the library or the device is missing.
    static std::unique_ptr<NvmlState> open(const std::string& name, const std::string& pci_address) {
        std::unique_ptr<NvmlState> state(new NvmlState);
        state->library_.reset(dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL));
        Nvml& nvml = state->nvml_;
        const Library& library = state->library_;
        const bool complete = library && look_up(library, "nvmlInit_v2", nvml.init) &&
                              look_up(library, "nvmlShutdown", nvml.shutdown) &&
                              look_up(library, "nvmlDeviceGetHandleByPciBusId_v2", nvml.handle_by_pci) &&
                              look_up(library, "nvmlDeviceGetClockInfo", nvml.clock) &&
                              look_up(library, "nvmlDeviceGetTemperature", nvml.temperature) &&
                              look_up(library, "nvmlDeviceGetCurrentClocksThrottleReasons", nvml.throttle_reasons);
        if (!complete || nvml.init() != Nvml::success) return nullptr;
        state->initialised_ = true;
        if (nvml.handle_by_pci(pci_address.c_str(), &state->handle_) != Nvml::success) return nullptr;
        return state;
    }

    ~NvmlState() override {
        if (initialised_) nvml_.shutdown();
    }
    NvmlState(const NvmlState&) = delete;
    NvmlState& operator=(const NvmlState&) = delete;

    DeviceState read() override {
        DeviceState state;
        unsigned value = 0;
        if (nvml_.clock(handle_, Nvml::graphics_clock, &value) == Nvml::success) state.clock_mhz = value;
        if (nvml_.clock(handle_, Nvml::memory_clock, &value) == Nvml::success) state.memory_clock_mhz = value;
        if (nvml_.temperature(handle_, Nvml::gpu_temperature, &value) == Nvml::success) state.temperature_c = value;
        unsigned long long reasons = 0;
        if (nvml_.throttle_reasons(handle_, &reasons) == Nvml::success)
            state.throttled = (reasons & Nvml::heat_or_power) != 0;
        return state;
    }

private:
    NvmlState() = default;

    Library library_;
    Nvml nvml_;
    Nvml::Handle handle_ = nullptr;
    bool initialised_ = false;
};

}  // namespace

std::unique_ptr<DeviceStateSource> open_nvml_state(const std::string& library, const std::string& pci_address) {
    return NvmlState::open(library, pci_address);
}

std::unique_ptr<DeviceStateSource> open_amdgpu_state(const fs::path& pci_devices, const std::string& pci_address) {
    for (const fs::path& hwmon : entries(pci_devices / pci_address / "hwmon", "hwmon")) {
        std::ifstream stream(hwmon / "name");
        std::string name;
        if (stream >> name && name == "amdgpu") return std::make_unique<AmdgpuState>(hwmon);
    }
    return nullptr;
}

std::unique_ptr<DeviceStateSource> open_cpu_state(const fs::path& processors) {
    std::vector<fs::path> files;
    for (const fs::path& processor : entries(processors, "cpu")) {
        fs::path file = processor / "cpufreq" / "scaling_cur_freq";
        if (read_number(file, 1)) files.push_back(std::move(file));
    }
    if (files.empty()) return nullptr;
    return std::make_unique<CpuState>(std::move(files));
}

std::unique_ptr<DeviceStateSource> open_device_state(const Device& device) {
    const DeviceInfo& info = device.info();
    std::unique_ptr<DeviceStateSource> source;
    if (info.type == DeviceType::cpu) source = open_cpu_state("/sys/devices/system/cpu");
    if (!info.pci_address.empty()) {
        if (!source) source = open_nvml_state("libnvidia-ml.so.1", info.pci_address);
        if (!source) source = open_amdgpu_state("/sys/bus/pci/devices", info.pci_address);
    }
    if (!source) source = std::make_unique<NothingTells>();
    return source;
}

}  // namespace reliefbench::gpu
