#include "engine/still.h"

#include "engine/cockpit/cockpit_still.h"
#include "engine/hud/image_text.h"
#include "engine/hud/legend.h"
#include "engine/picture_maker.h"
#include "render/shown_picture.h"

#include <algorithm>
#include <optional>

namespace engine {
namespace {

/// The height, in points, that the instruments are laid out for.
constexpr float layout_height = 720.0F;

/// What a cockpit's screens show of an eye that nobody has flown to where it is.
HudModel still_instruments(const PictureRequest& request) {
    sim::VehicleState moment;
    moment.world_from_vehicle = {request.frame.eye.world_from_head.spin};
    HudModel model;
    model.title = request.scenario.name;
    model.readings = sim::readings(moment);
    model.clock_unit = request.scenario.clock_unit_name;
    model.world_clock = request.time / request.scenario.clock_unit_seconds;
    model.mode = request.frame.mode;
    return model;
}

content::Image pane_image(const content::SceneDesc& scene, PictureRequest request, std::size_t index,
                          const PaneArea& area) {
    const Pane& pane = request.panes[index];
    request.frame = pane_frame(request.frame, pane, 0, area);
    const render::Picture light = make_picture(scene, request);
    const double stops = render::exposure_stops(light, request.frame.exposure);
    content::Image image = render::shown_picture(light, request.frame, stops, request.primaries);
    if (request.cockpit) {
        draw_cockpit_over(image, scene, request.frame, still_instruments(request), stops);
    }
    if (request.legend) {
        const ImageText text(std::max(static_cast<float>(area.height) / layout_height, 0.75F));
        if (const std::optional<Legend> legend = legend_of(request.frame.display, request.rapidity, stops)) {
            stamp_legend(image, *legend, text);
        }
        if (request.panes.size() > 1) {
            stamp_name(image, pane_name(pane), text);
        }
    }
    return image;
}

void put(const content::Image& pane, const PaneArea& area, content::Image& whole) {
    const auto row = static_cast<std::ptrdiff_t>(4) * pane.width;
    for (int y = 0; y < pane.height; ++y) {
        std::copy_n(pane.rgba.begin() + y * row, row,
                    whole.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(area.top + y) * whole.width + area.left));
    }
}

} // namespace

content::Image make_still(const content::SceneDesc& scene, const PictureRequest& request) {
    const int width = request.frame.eye.width;
    const int height = request.frame.eye.height;
    content::Image whole;
    whole.width = width;
    whole.height = height;
    whole.rgba.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const std::vector<PaneArea> areas = pane_areas(request.panes.size(), width, height);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        if (areas[i].width > 0 && areas[i].height > 0) {
            put(pane_image(scene, request, i, areas[i]), areas[i], whole);
        }
    }
    return whole;
}

} // namespace engine
