#pragma once

#include "engine/cameras/camera_settings.h"
#include "engine/cameras/other_ship.h"
#include "engine/flight.h"
#include "engine/hud/navigation_reading.h"
#include "render/render_frame.h"

#include <string>
#include <vector>

namespace engine {

/// An observer at one moment.
struct Observer {
    sim::Event event;
    sim::Lorentz<sim::World, sim::Head> world_from_head;
    double clock = 0.0; ///< own proper time, clock units
};

/// What the instruments say of a camera that is not the pilot's.
struct CameraReading {
    std::string name;
    double clock = 0.0; ///< own proper time, clock units
};

/// Sees a flight, which keeps its world line, by other eyes than the pilot's, and other ships by any. A picture's
/// moment is the ship's; another observer's is the one of the same time of the world:
///   free, chase: an observer at rest in the ship's frame of that moment, away from the pilot by a fixed r; the clock
///     runs as tau + r.(integral of a dtau). Turning carries the camera around, but is not seen as motion.
///   world: inertial; the clock shows t sqrt(1 - v^2).
///   twin: the pilot of the first other ship.
/// All of them see every ship by the light that reaches them.
class Cameras {
  public:
    Cameras(const content::Scenario& scenario, CameraSettings settings, std::vector<OtherShip> others);

    CameraKind kind() const { return settings_.kind; }
    bool is_pilots() const { return settings_.kind == CameraKind::pilot; }
    bool has_twin() const { return !others_.empty(); }
    /// Whether a picture shows anything of this at all: if not, it costs nothing.
    bool idle() const { return is_pilots() && others_.empty(); }
    /// Another camera. The world's is put beside the ship's way where the flight stands now.
    void choose(CameraKind kind, const sim::VehicleState& moment);
    /// The next by the table of names, without those that there are not.
    void choose_next(const sim::VehicleState& moment);
    /// Moves the free camera, scene metres, vehicle axes.
    void move(const glm::dvec3& by);

    /// Makes the pilot's frame of a flight at a moment the chosen camera's, turned by `look` (as a head in a vehicle),
    /// and adds the ships that it sees: those that it is not within. The pilot's own eye stays as it is.
    void apply(const Flight& flight, const sim::VehicleState& moment, const glm::dquat& look,
               render::RenderFrame& frame) const;

    /// Name and clock of the camera at a moment.
    CameraReading reading(const Flight& flight, const sim::VehicleState& moment) const;
    /// The clocks of the ships that the frame of `apply` shows: where and as they are seen. Beacons' not for the pilot.
    std::vector<ClockReading> clocks(const Flight& flight, const render::RenderFrame& frame) const;

  private:
    struct Shown {
        std::string name;
        std::shared_ptr<const sim::ShipWorldLine> world_line;
        double full_thrust = 1.0;
        bool is_beacon = false;
    };
    bool same_light(const Flight& flight) const;
    std::vector<Shown> shown(const Flight& flight) const;
    glm::dvec3 place_in_ship() const;
    glm::dvec3 world_place(const Flight& flight) const;
    Observer observer(const Flight& flight, const sim::VehicleState& moment, const glm::dquat& look) const;
    Observer aboard(const Flight& flight, const sim::VehicleState& moment, const glm::dquat& look) const;
    Observer in_the_world(const Flight& flight, const sim::VehicleState& moment, const glm::dquat& look) const;
    Observer in_twin(const sim::VehicleState& moment, const glm::dquat& look) const;

    double metres_per_light_unit_;
    CameraSettings settings_;
    std::vector<OtherShip> others_;
    std::shared_ptr<const render::ShipBody> body_;
};

} // namespace engine
