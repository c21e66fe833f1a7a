#pragma once

#include "render/gl/star_points.h"
#include "render/star_sheet.h"
#include "render/stereo_share.h"

#include <optional>

namespace render {

/// The stars of a scene in OpenGL: points on graphics hardware; on software OpenGL, where each point costs about a
/// microsecond, a sheet computed on the CPU and laid over the sky in one pass.
class StarLayer {
  public:
    enum class Way : std::uint8_t { automatic, points, sheet };

    /// Keeps a reference: `colour` must outlive this.
    StarLayer(const content::SceneDesc& scene, const DopplerColour& colour, Way way = Way::automatic);

    bool empty() const { return empty_; }

    /// Adds the stars' light times `pre_exposure`, times the sky's visibility in the target's alpha, to the bound
    /// framebuffer, whose lower left frame.eye.width x height pixels are the picture. Leaves blending off and the
    /// viewport on the picture.
    /// `share`: of both eyes of a headset; may be null.
    void draw(const RenderFrame& frame, const sim::BoostAndRotation& eye, double pre_exposure,
              StereoShare* share = nullptr);

  private:
    void draw_sheet(const RenderFrame& frame, double pre_exposure, StereoShare* share);

    bool empty_;
    std::optional<StarPoints> points_;
    std::optional<StarSheet> sheet_;
    std::vector<glm::vec4> pixels_;
    Program program_;
    VertexArray no_attributes_;
    Texture texture_;
    int width_ = 0;
    int height_ = 0;
};

} // namespace render
