#include "cli/device_lock.hpp"

#include "core/error.hpp"

#include <CLI/CLI.hpp>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace reliefbench {

namespace {

/// Of a socket in Linux's abstract name space: it needs no file, so that nothing is left behind and nobody's
/// permissions are in the way.
struct Address {
    sockaddr_un value{};
    socklen_t length = 0;
};

Address address_of(const gpu::DeviceInfo& device) {
    std::string name = "reliefbench device ";
    if (device.type == gpu::DeviceType::cpu) {
        name += "CPU";
    } else {
        name += device.pci_address.empty() ? device.name : device.pci_address;
    }
    Address address;
    address.value.sun_family = AF_UNIX;
    // The zero at the front makes the name abstract.
    const std::size_t length = std::min(name.size(), sizeof(address.value.sun_path) - 1);
    std::copy_n(name.begin(), length, &address.value.sun_path[1]);
    address.length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + length);
    return address;
}

int make_socket() {
    const int descriptor = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (descriptor < 0) fail("cannot make the lock of a device: {}", std::strerror(errno));
    return descriptor;
}

/// The process that has the address; empty when it ended meanwhile.
std::optional<pid_t> holder(const Address& address) {
    const int descriptor = make_socket();
    ucred credentials{};
    socklen_t size = sizeof credentials;
    const bool told = connect(descriptor, reinterpret_cast<const sockaddr*>(&address.value), address.length) == 0 &&
                      getsockopt(descriptor, SOL_SOCKET, SO_PEERCRED, &credentials, &size) == 0;
    close(descriptor);
    return told ? std::optional(credentials.pid) : std::nullopt;
}

}  // namespace

DeviceLock::DeviceLock(const gpu::DeviceInfo& device, const std::function<bool()>& is_interrupted) {
    constexpr std::chrono::milliseconds between_tries{100};
    constexpr int backlog = 16;
    const Address address = address_of(device);
    const int descriptor = make_socket();
    for (bool told = false; bind(descriptor, reinterpret_cast<const sockaddr*>(&address.value), address.length) != 0;) {
        const int reason = errno;
        if (reason != EADDRINUSE || (is_interrupted && is_interrupted())) {
            close(descriptor);
            if (reason == EADDRINUSE) return;
            fail("cannot lock {}: {}", device.name, std::strerror(reason));
        }
        if (const std::optional<pid_t> process = told ? std::nullopt : holder(address)) {
            fmt::print(stderr,
                       "process {} measures times on {}; waiting for its end (--share-device measures beside it)\n",
                       *process, device.name);
            told = true;
        }
        std::this_thread::sleep_for(between_tries);
    }
    // So that others can ask who holds it.
    listen(descriptor, backlog);
    descriptor_ = descriptor;
}

DeviceLock::~DeviceLock() {
    if (descriptor_ >= 0) close(descriptor_);
}

DeviceLock::DeviceLock(DeviceLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

DeviceLock& DeviceLock::operator=(DeviceLock&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

std::optional<DeviceLock> DeviceSharing::lock(const gpu::DeviceInfo& device,
                                              const std::function<bool()>& is_interrupted) const {
    if (share) return std::nullopt;
    return DeviceLock(device, is_interrupted);
}

void DeviceSharing::add_to(CLI::App& command) {
    command
        .add_flag("--share-device", share,
                  "Do not wait for another process that measures times on the same device: both measure each other")
        ->envname("RELIEFBENCH_SHARE_DEVICE");
}

}  // namespace reliefbench
