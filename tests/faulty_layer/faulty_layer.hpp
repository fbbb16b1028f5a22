#pragma once

// What tests ask of the Vulkan layer VK_LAYER_RELIEFBENCH_faulty in their own process, by the names of its C functions.
// A process that only its environment reaches asks by variables, each the value of an integer specialization constant:
// RELIEFBENCH_CRASH_AT, RELIEFBENCH_LOSE_DEVICE_AT and RELIEFBENCH_REFUSE_MEMORY_AT, when a graphics pipeline has it.
// With RELIEFBENCH_WITHOUT_TESSELLATION or RELIEFBENCH_WITHOUT_ANISOTROPY the device lacks that feature.

extern "C" {

/// Counts calls from 0 on again. Call `fail_at` (counted from 0; negative: none) is not passed on: it returns
/// VK_ERROR_OUT_OF_DEVICE_MEMORY, or, when the device is to be lost by it, VK_ERROR_DEVICE_LOST, as do all that follow.
void faulty_layer_start(long fail_at, bool lose_device);

/// Calls since then.
long faulty_layer_calls();

/// Name of the function that the call was of; null beyond the last.
const char* faulty_layer_name(long call);
}
