// What of NVIDIA's Management Library reliefbench calls, for a device that tests set up through its variables.

#include <cstring>

extern "C" {

constexpr int success = 0;
constexpr int not_supported = 3;
constexpr int not_found = 6;

int fake_users = 0;
bool fake_knows_clocks = true;
unsigned long long fake_throttle_reasons = 0;

static int fake_device = 0;

int nvmlInit_v2() {
    ++fake_users;
    return success;
}

int nvmlShutdown() {
    --fake_users;
    return success;
}

int nvmlDeviceGetHandleByPciBusId_v2(const char* address, void** handle) {
    if (std::strcmp(address, "0000:65:00.0") != 0) return not_found;
    *handle = &fake_device;
    return success;
}

int nvmlDeviceGetClockInfo(void* handle, int type, unsigned* mhz) {
    if (handle != &fake_device || !fake_knows_clocks) return not_supported;
    *mhz = type == 0 ? 1980 : type == 2 ? 2619 : 1;
    return success;
}

int nvmlDeviceGetTemperature(void* handle, int sensor, unsigned* degrees) {
    if (handle != &fake_device || sensor != 0) return not_supported;
    *degrees = 41;
    return success;
}

int nvmlDeviceGetCurrentClocksThrottleReasons(void* handle, unsigned long long* reasons) {
    if (handle != &fake_device) return not_supported;
    *reasons = fake_throttle_reasons;
    return success;
}
}
