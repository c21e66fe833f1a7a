#pragma once

#include "content/scenario.h"
#include "engine/cameras/cameras.h"
#include "engine/film.h"
#include "engine/fly/fly_options.h"
#include "engine/frame_builder.h"
#include "engine/hud/imgui_layer.h"
#include "engine/navigation.h"
#include "engine/offscreen.h"
#include "render/gl/egl_context.h"
#include "render/gl/renderer.h"
#include "render/picture_file.h"

#include <optional>
#include <string>
#include <vector>

namespace engine {

/// Draws a headless flight's pictures: frames of a film with instruments, and stills without.
class PictureLog {
  public:
    /// `name`: how the stills' files begin. Loads the scene; throws sim::BadInput. What cannot be written is a trouble.
    PictureLog(const content::Scenario& scenario, const FlyOptions& options, std::string name);

    bool has_film() const { return film_.has_value(); }
    /// Draws the flight as it is and adds it to the film, and as a still when asked: prints where that is.
    void add(const Flight& flight, double fraction, bool still);
    /// Completes the film. One line for it, and for each thing that could not be written.
    std::vector<std::string> finish();

  private:
    void save_still(const content::Image& picture, const render::PictureMetadata& metadata);

    const content::Scenario& scenario_;
    std::filesystem::path stills_folder_;
    std::string name_;
    double frames_per_second_;
    bool instruments_;
    Navigation navigation_;
    Cameras cameras_;
    render::EglContext context_;
    render::Renderer renderer_;
    Offscreen screen_;
    std::optional<ImguiLayer> hud_;
    std::optional<Film> film_;
    PictureSettings picture_;
    int film_pictures_ = 0;
    int stills_ = 0;
    std::vector<std::string> troubles_;
};

} // namespace engine
