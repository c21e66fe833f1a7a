#pragma once

#include "content/scene_desc.h"
#include "render/render_frame.h"
#include "render/stereo_share.h"

#include <cstdint>
#include <memory>

namespace render {

/// How the world is drawn.
enum class Method : std::uint8_t {
    automatic, ///< ray on software OpenGL; on graphics hardware plain at rest (rapidity below 1e-4), else texture
    texture,   ///< adaptive perspective tiles of the world at rest, then one warp pass
    plain,     ///< straight to the screen, as an eye at rest in the world sees it
    ray,       ///< rays cast on the processor (RayCaster); OpenGL only shows them
};

/// What stays the same for every frame of a renderer.
struct RendererSettings {
    Method method = Method::automatic;
    int shadow_map_size = 4096;  ///< texels along each side of the sun's shadow map
    bool measure_stages = false; ///< wait for OpenGL after each stage so that FrameStatistics tells their costs
};

/// Part of the target framebuffer, in pixels from its lower left corner.
struct Viewport {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// Cost of one stage of a frame, measured only with RendererSettings::measure_stages.
struct StageCost {
    double wall_ms = 0.0;
    double cpu_ms = 0.0; ///< of the whole process, all threads: on software OpenGL this is the work done
};

/// What the last frame took.
struct FrameStatistics {
    Method method = Method::plain; ///< the one used: never automatic
    int tiles = 0;
    double texels_per_pixel = 0.0; ///< rendered texels of all tiles, gutters included, per screen pixel
    std::int64_t triangles = 0;    ///< submitted to OpenGL
    double sharpness = 1.0;
    double exposure_stops = 0.0; ///< log2 of the factor on radiance that was used
    StageCost plan;
    StageCost scene; ///< tiles, the scene straight to the screen, or rays cast and shaded
    StageCost warp;
    StageCost stars;
    StageCost display;
};

/// Draws a scene as a moving eye sees it. Needs an OpenGL 4.5 context current on the calling thread, the same one from
/// construction to destruction; the caller owns it (a window's or an EglContext).
class Renderer {
  public:
    /// Takes the scene over. Throws sim::BadInput when the context is not OpenGL 4.5.
    Renderer(content::SceneDesc scene, const RendererSettings& settings);
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Draws a frame, tone-mapped and sRGB-encoded, into `viewport` of `target_framebuffer` (0: the window).
    /// frame.eye.width and height are the size of the picture computed; it is scaled to the viewport.
    /// frame.layer is ignored: this shows light.
    /// `share`: what this eye has in common with another one of the same moment, drawn before or after; may be null.
    FrameStatistics draw(const RenderFrame& frame, unsigned target_framebuffer, const Viewport& viewport,
                         StereoShare* share = nullptr);

    /// Copies the depths of the last draw, whose frame had keep_depth, into the lower left corner of a texture
    /// (GL_DEPTH_COMPONENT32F), see nearest_depth. False, and nothing copied, where the eye moved: what it sees is not
    /// where the scenery is, and must not be reprojected as if it were.
    bool copy_depth(unsigned depth_texture) const;

    /// Draws a frame of any layer and reads it back. Light comes as three channels of linear sRGB after exposure;
    /// doppler 1 channel, direction 3, distance 1, object 1 (see Layer).
    Picture picture(const RenderFrame& frame);

    /// Light as picture() gives it, by a manual exposure and in a target of its own: a small picture beside the main
    /// one that changes neither its automatic exposure nor its statistics.
    Picture small_picture(const RenderFrame& frame);

    /// Statistics of the last draw or picture.
    const FrameStatistics& statistics() const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace render
