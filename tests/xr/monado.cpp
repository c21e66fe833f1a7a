#include "tests/xr/monado.h"

#include <catch2/catch_test_macros.hpp>

#include <arpa/inet.h>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace xr_kit {
namespace {

namespace fs = std::filesystem;

void set(const char* name, const std::string& value) {
    REQUIRE(setenv(name, value.c_str(), 1) == 0);
}

/// A file descriptor that closes itself.
class Socket {
  public:
    Socket() : number_(socket(AF_INET, SOCK_STREAM, 0)) { REQUIRE(number_ >= 0); }
    ~Socket() { close(number_); }
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;
    int number() const { return number_; }

  private:
    int number_;
};

sockaddr_in loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
}

int free_port() {
    const Socket probe;
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof(address);
    REQUIRE(bind(probe.number(), reinterpret_cast<const sockaddr*>(&address), size) == 0);
    REQUIRE(getsockname(probe.number(), reinterpret_cast<sockaddr*>(&address), &size) == 0);
    return ntohs(address.sin_port);
}

/// The packet that Monado's remote driver reads, version 3.
struct RemoteView {
    std::array<float, 4> field_of_view{};
    std::array<float, 7> pose{0.0F, 0.0F, 0.0F, 1.0F};
    std::uint32_t padding = 0;
};
struct RemoteHead {
    std::array<RemoteView, 2> views;
    std::array<float, 7> centre{};
    bool view_data_valid = false;
};
struct RemoteHand {
    std::array<float, 7> pose{};
    std::array<float, 6> velocities{};
    std::array<float, 5> curl{};
    float trigger = 0.0F;
    float squeeze = 0.0F;
    float squeeze_force = 0.0F;
    std::array<float, 2> thumbstick{};
    float trackpad_force = 0.0F;
    std::array<float, 2> trackpad{};
    bool hand_tracked = false;
    bool active = true;
    bool system_click = false;
    bool system_touch = false;
    bool a_click = false;
    bool a_touch = false;
    bool b_click = false;
    bool b_touch = false;
    bool trigger_click = false;
    bool trigger_touch = false;
    bool thumbstick_click = false;
    bool thumbstick_touch = false;
    bool trackpad_touch = false;
    std::array<bool, 3> padding{};
};
struct RemotePacket {
    std::array<char, 8> header{'m', 'n', 'd', 'r', 'm', 't', '3', '\0'};
    RemoteHead head;
    RemoteHand left;
    RemoteHand right;
};
static_assert(sizeof(RemotePacket) == 376);

RemoteHand packed(const Hand& hand) {
    RemoteHand remote;
    remote.pose = {0.0F, 0.0F, 0.0F, 1.0F, hand.position[0], hand.position[1], hand.position[2]};
    remote.trigger = hand.trigger;
    remote.trigger_click = hand.trigger > 0.5F;
    remote.thumbstick = hand.thumbstick;
    remote.a_click = hand.a;
    remote.b_click = hand.b;
    return remote;
}

} // namespace

Folder::Folder() : path(fs::temp_directory_path() / ("rapidity-xr-" + std::to_string(std::random_device()()))) {
    fs::create_directories(path);
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
}

std::string monado_manifest() {
    const auto text = [](const char* name) -> std::string {
        const char* const value = std::getenv(name);
        return value != nullptr ? value : "";
    };
    // As .ci/install.sh says.
    fs::path folder = text("RAPIDITY_MONADO_DIR");
    if (folder.empty()) {
        const fs::path cache = text("XDG_CACHE_HOME");
        folder = (cache.empty() ? fs::path(text("HOME")) / ".cache" : cache) / "rapidity/monado-25.0.0";
    }
    const fs::path manifest = folder / "share/openxr/1/openxr_monado.json";
    if (!fs::exists(manifest)) {
        FAIL("Monado, the headset in software, is not at " << manifest.string() << ": ./check builds it");
    }
    return manifest.string();
}

namespace {

/// Nothing of what an earlier test of the same process asked for stays.
void use_monado() {
    for (const char* name : {"XR_API_LAYER_PATH", "XR_ENABLE_API_LAYERS", "SIMULATED_ENABLE",
                             "P_OVERRIDE_ACTIVE_CONFIG", "XDG_CONFIG_HOME"}) {
        REQUIRE(unsetenv(name) == 0);
    }
    set("XR_RUNTIME_JSON", monado_manifest());
    set("XRT_COMPOSITOR_NULL", "1");
}

} // namespace

void use_simulated_headset() {
    use_monado();
    set("SIMULATED_ENABLE", "1");
    set("SIMULATED_LEFT", "wmr");
    set("SIMULATED_RIGHT", "wmr");
}

struct RemoteHeadset::Connection {
    Socket socket;
};

RemoteHeadset::RemoteHeadset() : port_(free_port()) {
    use_monado();
    set("P_OVERRIDE_ACTIVE_CONFIG", "remote");
    fs::create_directories(folder_.path / "monado");
    std::ofstream(folder_.path / "monado/config_v0.json")
        << R"({"active":"remote","remote":{"version":0,"port":)" << port_ << R"(,"view_count":2}})";
    set("XDG_CONFIG_HOME", folder_.path.string());
}

RemoteHeadset::~RemoteHeadset() = default;

void RemoteHeadset::send() {
    if (!connection_) {
        connection_ = std::make_unique<Connection>();
        const sockaddr_in address = loopback(port_);
        int refused = 1;
        for (int i = 0; i < 500 && refused != 0; ++i) {
            refused =
                connect(connection_->socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof(address));
            if (refused != 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            }
        }
        REQUIRE(refused == 0);
        // It greets with two packets of its own.
        std::array<char, 2 * sizeof(RemotePacket)> greeting{};
        REQUIRE(recv(connection_->socket.number(), greeting.data(), greeting.size(), MSG_WAITALL) ==
                static_cast<ssize_t>(greeting.size()));
    }
    RemotePacket packet;
    packet.head.centre = {head_turn[0], head_turn[1], head_turn[2], head_turn[3], head[0], head[1], head[2]};
    packet.left = packed(left);
    packet.right = packed(right);
    REQUIRE(::send(connection_->socket.number(), &packet, sizeof(packet), MSG_NOSIGNAL) ==
            static_cast<ssize_t>(sizeof(packet)));
}

void use_faults(const std::string& faults) {
    set("XR_API_LAYER_PATH", RAPIDITY_FAULT_LAYER_FOLDER);
    set("XR_ENABLE_API_LAYERS", "XR_APILAYER_RAPIDITY_faults");
    set("RAPIDITY_FAULTS", faults);
}

} // namespace xr_kit
