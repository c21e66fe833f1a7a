#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

/// Monado in software, the headset that the tests fly in: an OpenXR runtime inside the test's own process.
namespace xr_kit {

/// A folder that goes with its owner.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path path;
};

/// Monado's manifest; fails the test when ./check has not built Monado.
std::string monado_manifest();

/// Points this process, and what it starts, at a headset whose head wobbles by 5 cm and 7.5 degrees, without a screen.
void use_simulated_headset();

/// What a controller of the remote headset does. Metres, in the room.
struct Hand {
    std::array<float, 3> position{0.2F, 1.3F, -0.5F};
    float trigger = 0.0F;
    std::array<float, 2> thumbstick{};
    bool a = false;
    bool b = false;
};

/// A headset and controllers (Valve's Index) that do what the test says.
class RemoteHeadset {
  public:
    /// Points this process at it.
    RemoteHeadset();
    ~RemoteHeadset();
    RemoteHeadset(const RemoteHeadset&) = delete;
    RemoteHeadset& operator=(const RemoteHeadset&) = delete;

    std::array<float, 3> head{0.0F, 1.6F, 0.0F};
    std::array<float, 4> head_turn{0.0F, 0.0F, 0.0F, 1.0F}; ///< quaternion x, y, z, w
    Hand left;
    Hand right;

    /// Tells the runtime, which must have been started by now; fails the test when it does not listen.
    void send();

  private:
    struct Connection;
    Folder folder_;
    int port_;
    std::unique_ptr<Connection> connection_;
};

/// Puts a layer between OpenXR's loader and the runtime that goes wrong as `faults` says (fault_layer.cpp).
void use_faults(const std::string& faults);

} // namespace xr_kit
