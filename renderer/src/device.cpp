// SPDX-License-Identifier: MIT
#include "device.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace flg::render {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";
constexpr const char* device_variable = "FLG_RENDERER_DEVICE";

bool has_extension(const std::vector<VkExtensionProperties>& extensions, const char* name) {
    return std::any_of(extensions.begin(), extensions.end(),
                       [name](const auto& e) { return std::strcmp(e.extensionName, name) == 0; });
}

std::vector<VkExtensionProperties> instance_extensions(const char* layer) {
    uint32_t count = 0;
    check(vkEnumerateInstanceExtensionProperties(layer, &count, nullptr), "list its instance extensions");
    std::vector<VkExtensionProperties> extensions(count);
    check(vkEnumerateInstanceExtensionProperties(layer, &count, extensions.data()), "list its instance extensions");
    extensions.resize(count);
    return extensions;
}

bool has_layer(const char* name) {
    uint32_t count = 0;
    check(vkEnumerateInstanceLayerProperties(&count, nullptr), "list its layers");
    std::vector<VkLayerProperties> layers(count);
    check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "list its layers");
    return std::any_of(layers.begin(), layers.begin() + count,
                       [name](const auto& l) { return std::strcmp(l.layerName, name) == 0; });
}

std::optional<uint32_t> graphics_family(VkPhysicalDevice physical, uint32_t* timestamp_bits) {
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    for (uint32_t i = 0; i < count; ++i) {
        if (!(families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT)) continue;
        if (timestamp_bits) *timestamp_bits = families[i].timestampValidBits;
        return i;
    }
    return std::nullopt;
}

int preference(VkPhysicalDeviceType type) {
    switch (type) {
        case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 4;
        case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 3;
        case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
        case VK_PHYSICAL_DEVICE_TYPE_CPU: return 1;
        default: return 0;
    }
}

}  // namespace

Device::Device(const Options& options, std::shared_ptr<MessageLog> log)
    : validation_(options.validation), log_(std::move(log)) {
    try {
        create_instance();
        create_messenger();
        const char* variable = std::getenv(device_variable);
        choose_physical(!options.device.empty() ? options.device : variable ? variable : "");
        create_device();
    } catch (...) {
        destroy();
        throw;
    }
}

Device::~Device() {
    destroy();
}

void Device::destroy() {
    if (device_) vkDestroyDevice(device_, nullptr);
    if (messenger_) {
        auto destroy_messenger = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
            vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
        destroy_messenger(instance_, messenger_, nullptr);
    }
    if (instance_) vkDestroyInstance(instance_, nullptr);
}

void Device::create_instance() {
    std::vector<const char*> extensions;
    const auto available = instance_extensions(nullptr);
    // Everything that a window might need, where the system has it: whether one is opened is decided later.
    for (const char* name : {"VK_KHR_surface", "VK_KHR_xcb_surface", "VK_KHR_xlib_surface", "VK_KHR_wayland_surface"})
        if (has_extension(available, name)) extensions.push_back(name);

    std::vector<const char*> layers;
    if (validation_) {
        if (!has_layer(validation_layer))
            fail("Validation was asked for, but the layer %s is not installed.", validation_layer);
        layers.push_back(validation_layer);
        extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    }

    const VkValidationFeatureEnableEXT enabled = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;
    VkValidationFeaturesEXT features{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.enabledValidationFeatureCount = 1;
    features.pEnabledValidationFeatures = &enabled;
    VkDebugUtilsMessengerCreateInfoEXT messenger = messenger_info();
    messenger.pNext = &features;

    VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "Filigree";
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    info.pNext = validation_ ? &messenger : nullptr;
    info.pApplicationInfo = &application;
    info.enabledLayerCount = static_cast<uint32_t>(layers.size());
    info.ppEnabledLayerNames = layers.data();
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    const VkResult result = vkCreateInstance(&info, nullptr, &instance_);
    if (result != VK_SUCCESS) fail("Vulkan could not be started: %s.", result_name(result));
}

VkDebugUtilsMessengerCreateInfoEXT Device::messenger_info() {
    VkDebugUtilsMessengerCreateInfoEXT info{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    // Not the general ones: those are the loader's, about other people's drivers.
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    info.pfnUserCallback = on_message;
    info.pUserData = this;
    return info;
}

void Device::create_messenger() {
    if (!validation_) return;
    auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkCreateDebugUtilsMessengerEXT"));
    if (!create) fail("The validation layer offers no way to read its messages.");
    const VkDebugUtilsMessengerCreateInfoEXT info = messenger_info();
    check(create(instance_, &info, nullptr, &messenger_), "set up the validation layer's messages");
}

VkBool32 Device::on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                            const VkDebugUtilsMessengerCallbackDataEXT* data, void* self) {
    auto* device = static_cast<Device*>(self);
    const std::lock_guard lock(device->log_->mutex);
    device->log_->messages.emplace_back(data->pMessage);
    return VK_FALSE;
}

void Device::choose_physical(const std::string& wanted_name) {
    uint32_t count = 0;
    check(vkEnumeratePhysicalDevices(instance_, &count, nullptr), "list the Vulkan devices");
    std::vector<VkPhysicalDevice> candidates(count);
    check(vkEnumeratePhysicalDevices(instance_, &count, candidates.data()), "list the Vulkan devices");

    int best = -1;
    std::string seen;
    for (VkPhysicalDevice candidate : candidates) {
        VkPhysicalDeviceProperties properties;
        vkGetPhysicalDeviceProperties(candidate, &properties);
        seen += (seen.empty() ? "" : ", ") + std::string(properties.deviceName);
        if (properties.apiVersion < VK_API_VERSION_1_1 || !graphics_family(candidate, nullptr)) continue;
        if (!wanted_name.empty() && std::string(properties.deviceName).find(wanted_name) == std::string::npos) continue;
        if (preference(properties.deviceType) <= best) continue;
        best = preference(properties.deviceType);
        physical_ = candidate;
        properties_ = properties;
    }
    if (seen.empty()) fail("There is no Vulkan device.");
    if (!physical_ && !wanted_name.empty())
        fail("No usable Vulkan device is named \"%s\"; there are: %s.", wanted_name.c_str(), seen.c_str());
    if (!physical_) fail("No Vulkan device offers Vulkan 1.1 and graphics; there are: %s.", seen.c_str());
    name_ = properties_.deviceName;
}

void Device::create_device() {
    queue_family_ = *graphics_family(physical_, &timestamp_bits_);
    uint32_t count = 0;
    check(vkEnumerateDeviceExtensionProperties(physical_, nullptr, &count, nullptr), "list its extensions");
    std::vector<VkExtensionProperties> available(count);
    check(vkEnumerateDeviceExtensionProperties(physical_, nullptr, &count, available.data()), "list its extensions");

    std::vector<const char*> extensions;
    has_swapchain_ = has_extension(available, VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    if (has_swapchain_) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);

    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue_info{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
    queue_info.queueFamilyIndex = queue_family_;
    queue_info.queueCount = 1;
    queue_info.pQueuePriorities = &priority;
    const VkPhysicalDeviceFeatures no_features{};
    // Part of Vulkan 1.1, together with any number of samples.
    VkPhysicalDeviceMultiviewFeatures stereo{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MULTIVIEW_FEATURES};
    stereo.multiview = VK_TRUE;
    VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
    info.pNext = &stereo;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue_info;
    info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
    info.ppEnabledExtensionNames = extensions.data();
    info.pEnabledFeatures = &no_features;
    check(vkCreateDevice(physical_, &info, nullptr, &device_), "be opened");
    vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
}

bool Device::seems_lost() const {
    if (!calls_until_loss_) return false;
    if (*calls_until_loss_ > 0) {
        --*calls_until_loss_;
        return false;
    }
    vkDeviceWaitIdle(device_);  // a lost device does nothing any more
    return true;
}

VkSampleCountFlagBits Device::supported_samples(uint32_t wanted) const {
    const VkSampleCountFlags both =
        properties_.limits.framebufferColorSampleCounts & properties_.limits.framebufferDepthSampleCounts;
    const uint32_t usual = properties_.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU ? 1 : 4;
    for (uint32_t samples = wanted ? wanted : usual; samples > 1; samples /= 2)
        if (both & samples) return static_cast<VkSampleCountFlagBits>(samples);
    return VK_SAMPLE_COUNT_1_BIT;
}

}  // namespace flg::render
