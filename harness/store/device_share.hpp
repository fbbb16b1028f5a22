#pragma once

#include "core/json.hpp"

#include <string>

namespace reliefbench {

/// Whether times were made with --share-device, beside other processes that may have measured on the same device.
enum class DeviceShare {
    /// The record is of a version that did not say so.
    unknown,
    never,
    /// In some executions of the run, or parts of it that were merged.
    partly,
    always,
};

/// Of a run's record (run.json): of its own execution, of each that resumed it, and of merged parts.
DeviceShare device_share(const Json& run);

/// What a reader of the times is told, as a sentence about `whose` ("the times"); empty for unknown and never.
std::string describe(DeviceShare share, const std::string& whose);

}  // namespace reliefbench
